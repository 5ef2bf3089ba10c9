"""The set-point over time, one profile per file.

=============== ======================================================================================
``profile``     the interface: name, length, speed and load at a time, breakpoints
``steady``      constant set-point
``ramp``        10 % to 100 % of the set-point, then constant
``reversal``    two sine periods
``duty_cycle``  segments, repeated
``tabulated``   straight lines between the rows of a table, once or repeated
``from_file``   reads a profile from a table file
``table_checks`` refuses gaps in a table and profiles that are shorter than the run
``breakpoints`` speed and load at points in time, straight lines between them, with steps
=============== ======================================================================================
"""
