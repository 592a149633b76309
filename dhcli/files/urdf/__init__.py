"""URDF, the XML that ROS describes robots in: one serial chain read as a robot, and a robot written as one."""
