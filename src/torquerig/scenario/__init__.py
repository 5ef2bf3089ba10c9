"""A scenario's file.

reading          file -> Rig with catalog values, uncertainties and assumptions
operating_point  speed, profile, occupancy, particle size -> the test sheet of the run
profile_text     a duty cycle or a table as written      planned        the same in speeds of the motor
drive_demand     speed and torque that a run asks of its motor
demand_check     the one place of the rules: the impossible is refused, what is beyond a rating flagged
from_catalog     what a catalog entry gives a part              motor_effects  the lines that come with a motor
filled           a part's data on its way to a validated part   overrides      --set path=value
phase_level      ripple out of the motor's phases, where a scenario asks for it
load_response    what the linear twin says the sensor makes of the load
kinematics       poles, slots, ratio, teeth and torque gain of a rig
"""
