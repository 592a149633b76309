"""Every pose of a grid of joint values: what of the space around a robot a point of it comes by."""
