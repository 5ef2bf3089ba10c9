"""The linear twin of a rig: what its shafts pass on to the reading, and what they ask for while nothing vibrates.

transfer       shafts to reading, on a grid           twin     lines and load spectrum of a rig
quasi_static   slow torque                            kernel   the compiled part
field_speed    the slip of an induction motor
"""
