"""Reading and writing text and bytes without surprises."""
