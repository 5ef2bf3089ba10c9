"""Results and decision of the reference report next to the simulated rig: pages and pictures."""
