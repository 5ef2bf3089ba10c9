"""What the machine is.

terms     the closed vocabulary of physics        part   what parts and effects have in common
parts/    motor, gear, sensor, coupling, body     rig    an immutable tuple of parts; ``rig + part``
turns     how fast a shaft turns against the motor  drive_train  what a motor drives, as its shaft feels it
stage_spring  a gear's spring with its effects    motor_drive  a motor's drive with its effects and encoder
steady    the motor's mean torque at the set-point  phase_level  lines of the phases at the set-point
"""
