"""Numbers as a scenario states them.

uncertain  ``{value, rel_sd}``, ``{low, high}``, ``5 N*m ± 10 %``    uncertain_text  the same written into a file
tolerance  one number with its uncertainty, in SI                   percent         the occupancy
"""
