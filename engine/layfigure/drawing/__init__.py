"""From figures and cameras to a list of primitives in pixels: all that a renderer ever gets."""
