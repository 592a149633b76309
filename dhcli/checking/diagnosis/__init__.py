"""Why an answer is wrong: the exercise worked out again under each known mistake, until one gives just the answer."""
