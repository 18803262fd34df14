"""What can become a film, one module per kind of file."""
