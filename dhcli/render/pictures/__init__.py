"""Figures in the formats people ask for; each writer is a pure function of a finished figure."""
