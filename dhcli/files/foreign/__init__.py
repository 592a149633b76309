"""Files of others that describe a robot: tables, listings of toolboxes, XML; told apart, and read as a robot."""
