"""Orders: the angle of the shaft, the order lines that poles, slots and teeth cause, and order analysis.

=================== ===============================================================================
``kinematics/``     the order lines of a motor and gearbox, coincident lines, and a better test speed
``angle/``          the motor's angle: measured, from a tacho, or estimated from the torque
``analysis/``       order spectrum and order map; lines of the shaft separated from fixed frequencies
``line_sums/``      compiled sums over order lines along an angle
=================== ===============================================================================
"""
