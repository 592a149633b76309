"""Every key of a robot, an exercise or a linkage file, told once: for loaders, for the manual, and for editors."""
