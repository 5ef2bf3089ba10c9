"""The motor's angle over a recording, from the best source that the recording has.

======================== ==========================================================================
``best_angle``           the best angle and mean speed of a recording, and their source
``measured_angle``       from an encoder, an angle channel or a speed channel
``tacho``                from the pulses of a tacho
``speed_from_torque``    from the known order lines of the torque, or the set-point where they do not determine it
``order_peaks``          peaks of the spectrum near known orders, with their uncertainty
``speed_posterior``      the 95 % interval of a constant speed from these peaks
``varying_angle``        a drift or a varying speed that further lines confirm
``line_likelihood``      the power of lines over the noise along an angle
``speed_trajectory``     a speed that varies by per cents: the most likely path (Viterbi)
``slow_angle_drift``     slow deviations of the angle from that path, from the lines' common phase
``periodic_angle_error`` deviations that repeat with each turn, from the side lines
``wide_speed_search``    the speed of a run whose stated speed is far off
``comb_score``           how far order lines exceed the noise floor along an angle
``speed_contradictions`` channels that contradict the set-point or each other, with the likely reason
``second_differences``   the banded matrix of a penalty on second differences
======================== ==========================================================================
"""
