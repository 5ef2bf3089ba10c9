"""A worked-out matrix as page, Markdown or file."""
