"""Order analysis of a recording: order spectrum, order map, and shaft lines separated from fixed frequencies.

==================== =================================================================================
``angle_resampling`` a signal at equal steps of the angle instead of time, and back
``order_spectrum``   amplitudes over the order of the output shaft; the amplitude of one line
``peaks``            local peaks above the noise floor
``line_domain``      whether a line follows the shaft or has a fixed frequency
``line_detection``   all lines above the noise floor, each with its domain, found in several passes
``labels``           names of a line: causes of its order, or a multiple of the mains
``order_envelope``   the amplitude of each order line over the turns of a shaft
``line_fit``         least-squares fit of order lines, block by block
``order_maps``       amplitudes by speed (or time) over order and over frequency: order map, Campbell diagram
==================== =================================================================================
"""
