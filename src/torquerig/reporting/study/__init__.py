"""The report of a study: page, CSV tables and text for the terminal."""
