"""Scenario files.

reading          file -> Rig with catalog values, uncertainties and assumptions
operating_point  speed, profile, occupancy, particle size -> the conditions of the run
profile_text     a duty cycle or a table as written      planned        the same in speeds of the motor
drive_requirement     required speed and torque of the motor
requirement_check     impossible requirements are errors, those beyond a rating are flagged
from_catalog     values of a part from a catalog entry           motor_effects  ripple lines of a motor
filled           a part's data before validation   overrides      --set path=value
phase_level      ripple from the motor's phases, if the scenario selects it
load_response    reading per load of the linear twin
kinematics       poles, slots, ratio, teeth and torque gain of a rig
"""
