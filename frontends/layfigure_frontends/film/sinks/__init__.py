"""One module per format. A sink takes a film's pictures one by one and writes them to a path."""
