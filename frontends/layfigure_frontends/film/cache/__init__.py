"""What was made before and need not be made again: finished films, and the scenes of films that have several."""
