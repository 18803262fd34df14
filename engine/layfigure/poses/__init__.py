"""Poses as values, their text files, and what can be asked of them."""
