"""The studio: a local page that works on the files of a folder, in six steps."""
