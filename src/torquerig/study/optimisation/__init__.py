"""The best ratio or gearbox, speed loop and filter for one motor, and what they cost against each other.

=================== ======================================================================================
``bounds``          what may vary, and between which limits
``varied_number``   a number of a filter that varies
``scaled_gearbox``  a gearbox of any ratio, scaled from the nearest one of the catalog
``choices``         numbers within the bounds, and the point of the search that stands for them
``tried_drives``    the drives: with gearboxes of the catalog, or with a scaled one
``tried``           one drive, speed loop and filter with its figures; ``front``: those that no other beats
``search``          differential evolution, a whole generation in one batch
=================== ======================================================================================
"""
