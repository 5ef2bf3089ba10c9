"""What the machine is.

terms     the closed vocabulary of physics        part   what parts and effects have in common
parts/    motor, gear, sensor, coupling, body     rig    an immutable tuple of parts; ``rig + part``
turns     how fast a shaft turns against the motor  steady  the motor's mean torque at the set-point
"""
