"""The angle that the motor turned through, from the best source that a recording has.

=========================== =======================================================================
``best_angle``              the best angle and speed that a recording has, and their source
``measured_angle``          from an encoder, an angle channel or a speed channel
``tacho``                   from the pulses of a tacho
``speed_from_torque``       from the known order lines of the torque
``speed_course``            where the speed wanders by per cents: the likeliest path of the speed
``wander``                  where the angle strays slowly from that path
``angle_within_a_turn``     where the angle ripples within each turn
``speed_far_off``           whether a run turns at quite another speed than stated
``coherence``               how far lines exceed the noise along an angle
``smooth_course``           the banded matrix that penalises second differences
=========================== =======================================================================
"""
