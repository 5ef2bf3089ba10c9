"""The angle of the motor in each run.

shaft_angle      measured, followed in the lines of the torque, or simulated from the set-point
speed_factor     by how much a moving run without an encoder is off its set-point
smoothed_speed   the speed by the angle
tacho_direction  which way the motor turned, where only a tacho was recorded
"""
