"""Articulated figures: trees of rigid limbs joined by swing-twist joints, and the ``.fig`` language."""
