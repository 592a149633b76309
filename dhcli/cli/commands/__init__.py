"""One file a command: find, compute, render."""
