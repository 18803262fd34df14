"""A session: one document under one history, driven by events or commands, shown as frames."""
