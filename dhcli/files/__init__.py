"""Files: YAML with places, loaders and writers, and the library of robots, linkages and exercises."""
