"""Loads near standstill, and the part that they act on; the linear twin is in ``torquerig.linear_twin``.

winding   slow torque near standstill     kernel   its compiled part     loaded_part   which part the load acts on
"""
