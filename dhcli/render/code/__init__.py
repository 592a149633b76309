"""Results for programs and papers: matrices, formulas and rows."""
