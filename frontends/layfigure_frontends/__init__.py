"""Front ends: the SDL window, the headless player, and the command line."""
