"""The kinds of questions: one class in one file for each, and the registry that a new one is added to."""
