"""Reference programs: the paper's equations in plain, slow NumPy, and other computations of the same results.

Equation numbers are those of Zéhil and Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings", whose
equations are changed only by the correction of misprints. The other programs use closed forms of limiting cases, finite
elements at small and finite strain, or more digits. Tests compare results of the C++ core with those of this package.

No program uses the core, except `finite_strain_table` and `finite_strain_slow`, which compare;
`tests/python/project/test_reference.py` checks this. The matrix product over radial sub-intervals (32) and the contact
condition (50) are in `viscoroll.reproduce.plain`, because `viscoroll reproduce` uses them for figure 4.
"""
