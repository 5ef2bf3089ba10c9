"""A scenario's file.

reading          file -> Rig with catalog values, uncertainties and assumptions
operating_point  speed, profile, occupancy, particle size -> the test sheet of the run
profile_text     a duty cycle or a table as written      planned        the same in speeds of the motor
from_catalog     what a catalog entry gives a part              motor_effects  the lines that come with a motor
filled           a part's data on its way to a validated part   overrides      --set path=value
kinematics       poles, slots, ratio, teeth and torque gain of a rig
"""
