"""Whole folders of files: what authors are told about their content."""
