"""How q and pose change together: Jacobians over every kind of number, torques, rates, and how well an arm moves."""
