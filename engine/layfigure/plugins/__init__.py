"""The plug-in house: hook specifications, the records they hand over, and the host that guards them."""
