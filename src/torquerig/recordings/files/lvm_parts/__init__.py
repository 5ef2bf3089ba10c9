"""The parts of an LVM file.

========= ==================================================================
``text``  tags, labels and rows of each segment
``rows``  the rows as numbers, with the line of a faulty one
``times`` the sample rate of a channel from Delta_X and its X values
========= ==================================================================
"""
