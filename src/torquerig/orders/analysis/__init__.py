"""What a recording shows over the angle of its shaft: order spectrum, order map, and lines told from fixed ones.

even_angle      a signal at equal steps of the angle instead of time
order_spectrum  amplitudes over the order of the output shaft; the amplitude of one line, exactly at its order
peaks           what stands out of the floor beside it
line_domain     whether a line belongs to the shaft or to the clock: which of the two gathers it more
found_lines     all lines that stand out, each with its domain; what is decided is taken out before the next look
labels          what a found line is: causes of its order, or a multiple of the mains
maps            amplitudes by speed (or time) over order, and over frequency: order map and measured Campbell diagram
"""
