"""The library: what there is, and where a name is found."""
