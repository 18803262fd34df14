"""The line prompt: a front end of sentences, for screen readers, dumb terminals and pipes of commands."""
