"""What a careful lecturer would want to know of exercises, robots and linkages: rules over data that loads."""
