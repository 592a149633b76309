"""Questions from the pose back to the joints: the pose that is asked about, its solutions, and slips on the way."""
