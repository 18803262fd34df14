"""Scenes: who acts when and where, seen through which camera, as pictures ready to be drawn."""
