"""The linear twin of a rig: what it does for small changes about one operating point. ``twin.twin_of(rig)`` has all.

twin             all of it in one place
operating_point  the steady state it is taken about, and what is left out     plant   the arrays as A, B, C, D
friction_slope   friction about a steady speed: torque, slope, what a linear twin misses of it
system           named inputs, outputs and states; python-control             loop    the speed loop closed
modes            frequencies, damping, shapes in words                        shapes  who turns against whom
sensing          what the loop sees of its speed: encoder and filter
margins          gain, phase and modulus margin of the speed loop             lines   order lines and what they act on
crossings        Campbell: which line meets which mode, at what speed, how strongly
line_inputs      the lines at constant speed as phasors                       blocks  exact recursion, a block at a time
"""
