"""The kinds of number that a chain or a tree can be computed in: floats, numpy columns, terms, residues, sympy."""
