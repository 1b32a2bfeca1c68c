"""The paper's equations in plain NumPy, dense and slow, with only the misprints corrected; and closed forms of limits.

Equation numbers are those of Zéhil and Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings". Tests
compare the C++ core with this package entry by entry, and nothing here uses the core. The product (32) and the contact
condition (50) are in `viscoroll.reproduce.plain`, because `viscoroll reproduce` uses them for figure 4.
`tests/python/project/test_reference.py` checks that these modules use only NumPy and other libraries, not the core.
"""
