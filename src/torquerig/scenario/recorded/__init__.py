"""A scenario and the recordings of its rig.

compared_channel  which column is which measured place   input_checks     whether every recording has the inputs
recorded_drive    what is known of a recording's drive   recording_lines  lines that its motor and gearbox can have
sensor_priors     scale and zero of every sensor before a recording is seen
"""
