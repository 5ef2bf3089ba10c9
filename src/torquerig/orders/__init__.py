"""Shafts and their lines: the angle of the shaft, the orders that poles, slots and teeth give, and order analysis.

=================== ===============================================================================
``kinematics/``     the order lines of a motor and gearbox, what coincides, and a better test speed
``angle/``          the motor's angle: measured, by a tacho, or followed in the torque
``analysis/``       order spectrum and order map; lines of the shaft separated from fixed frequencies
``turning/``        compiled sums over order lines along an angle
=================== ===============================================================================
"""
