"""Questions, answers and how answers are judged: as a fair lecturer would, and never by comparing text."""
