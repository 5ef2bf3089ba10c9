"""Forwards: from a rig to a recording.

simulate  the one verb              lower    Rig -> flat arrays       waves   which cosines, with few sine calls
kernel    the compiled loop         profile  set-point over time      linear  the same arrays as M, C, K and StateSpace
"""
