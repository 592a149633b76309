"""Every rule for authors, and the walk over their files; rules look at data that loads."""
