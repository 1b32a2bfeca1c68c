"""The paper as written, in plain NumPy: dense, slow, and with only its misprints mended; and closed forms of limits.

Equation numbers are those of Zéhil and Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings". The
C++ core is checked against this package entry by entry, and nothing here uses the core. The product (32) and the
contact condition (50) live in `viscoroll.reproduce.plain`, since figure 4 of `viscoroll reproduce` is drawn with them:
they are NumPy alone, which `tests/python/project/test_reference.py` holds them to.
"""
