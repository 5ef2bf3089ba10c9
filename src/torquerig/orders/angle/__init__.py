"""The motor's angle over a recording, from the best source that the recording has.

======================== ==========================================================================
``best_angle``           the best angle and mean speed of a recording, and their source
``measured_angle``       from an encoder, an angle channel or a speed channel
``tacho``                from the pulses of a tacho
``speed_from_torque``    from the known order lines of the torque
``speed_trajectory``     a speed that varies by per cents: the most likely path (Viterbi)
``slow_angle_drift``     slow deviations of the angle from that path, from the lines' common phase
``periodic_angle_error`` deviations that repeat with each turn, from the side lines
``wide_speed_search``    the speed of a run whose stated speed is far off
``comb_score``           how far order lines exceed the noise floor along an angle
``second_differences``   the banded matrix of a penalty on second differences
======================== ==========================================================================
"""
