"""The terminal front end measured: bytes and time of a frame, and whole programs behind links of several speeds."""
