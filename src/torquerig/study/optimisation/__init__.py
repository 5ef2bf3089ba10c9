"""The best gearbox, speed loop and filter for one motor, and what they cost against each other.

=========== ==========================================================================
``bounds``  what may vary, and between which limits
``tried``   one gearbox, speed loop and filter with its figures
``search``  differential evolution over the speed loop, a whole generation in one batch
``front``   the choices that no other is better than in every figure
=========== ==========================================================================
"""
