"""What makers print, converted once to the fields of a catalog entry, with the conversion in words.

- ``words``       the words that decide what a figure means: rms, line-to-line, delta, S3 40 %
- ``figure``      one printed figure: number, unit and words
- ``sheet``       the block ``as_printed`` of a motor file
- ``reading_of``  the readings that a figure allows, and the range over them
- ``emf``         torque constant from Kt, Ke or kV
- ``phase``       resistance and inductance of one phase
- ``friction``    friction from the no-load current
- ``ratings``     torque from power, S1 and S3 ratings; inertia from GD^2
- ``shares``      cogging and ripple as shares, zero to peak
- ``conversion``  a motor's document with the converted values
"""
