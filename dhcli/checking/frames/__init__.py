"""Frames as answers: z and x axes and origins that a student puts on a robot's axes, judged rule by rule."""
