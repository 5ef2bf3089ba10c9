"""What the option ``--json`` of the commands writes: one frozen dataclass per command, from which its schema derives.

================ ==================================================================================
``values``       quantities with unit, missing values with their reason, results as plain values
``provenance``   version, hash of the sources and of the input files, seed
``document``     the whole document of a command, and its text
``registry``     the result class of each command, by the name in its schema
``orders`` ...   the result of one command, and how it follows from what the command computed
================ ==================================================================================
"""
