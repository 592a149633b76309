"""Where a robot loses motions: determinants in factors and conditions by rules, each proved in residues."""
