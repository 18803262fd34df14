"""Says poses, places and changes in words, by rules on where limbs are and how they are bent."""
