"""The paper as written, in plain NumPy: dense, slow, and with only its misprints mended.

Equation numbers are those of Zéhil and Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings". The
C++ core is checked against this package entry by entry; nothing here knows of it.
"""
