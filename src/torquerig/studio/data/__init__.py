"""Recordings in the studio: files that are dropped, what is in them, and the form of their sidecar.

received      a file that was dropped, written whole into the folder
shown_file    what each column is taken for, as the page shows it
sheet_form    the fields of a sidecar
"""
