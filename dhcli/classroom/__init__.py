"""A folder of sheets graded, and files of a course linted."""
