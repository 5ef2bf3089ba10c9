"""What a MATLAB file holds: its variables as a tree, from each version of the format, and the channels in them.

=============== =====================================================================================
``tree``        numbers, texts, structs, and variables that are not read, with the reason
``version4``    the variables of a v4 file
``version5``    the variables of a v5, v6 or v7 file; each size is checked before it is used
``version73``   the variables of a v7.3 file (HDF5), without their numbers
``tables``      tables and timetables, through mat-io where it is installed
``leaves``      the numbers of the tree with their paths, labels and units
``headers``     what other variables state about a variable: headers of catman, ``torque_unit``
``stated_rate`` the sample rate that scalars and attributes state by their names
``channels``    the channels: names, units, rates and times from variables and structs
=============== =====================================================================================
"""
