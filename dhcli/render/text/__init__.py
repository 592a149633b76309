"""Results for people, on a terminal or on paper."""
