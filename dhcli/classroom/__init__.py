"""A folder of sheets graded, in parallel, and the report on a class."""
