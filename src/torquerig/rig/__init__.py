"""The model of a machine: parts on shafts, with effects inside them.

================= ===============================================================================
``assembly``      a rig, an immutable tuple of parts (``rig + part``), and the interface of a part
``terms/``        the closed vocabulary of physics
``parts/``        motor, gear, sensor, coupling, body and others
``host_changes``  the changes that an effect can make inside its host part
``placed_stage``  a stage of the measuring chain with its position
``turns``         turns of a shaft relative to the motor
``speed_ratios``  turns of each shaft per turn of another
``drive_train``   the drive train reduced to the motor shaft
``stage_spring``  the spring of a gear or coupling with its effects
``motor_drive``   a motor's drive with its effects and encoder
``steady``        mean torques at the set-point
``phase_level``   torque lines of the motor's phases at the set-point
``leading_part``  the part that the set-point belongs to
``first_mode``    the first elastic mode of the shafts
``reading_place`` the part at which a measured place reads
``sensor_reading`` scale, zero and mounting of a sensor; ``amplified_sensor``: amplifier, noise and converter
``point_sensor``  what speed, acceleration and current sensors share
``bearing``       friction of a part against the frame
``housing``       a motor's housing on a reaction torque sensor
``mean_by_occupancy`` mean load over the occupancy of the drum
================= ===============================================================================
"""
