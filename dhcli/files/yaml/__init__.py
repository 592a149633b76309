"""YAML with places, and what is written in it: robots, linkages, exercises and answer sheets."""
