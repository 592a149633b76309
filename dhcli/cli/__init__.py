"""The command line: find, compute, render."""
