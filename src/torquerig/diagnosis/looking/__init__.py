"""What recordings show, before any model is asked.

shaft_angle     the motor's angle of each run          observed     a run made ready to compare
sample_faults   coarse codes, dropouts                 value_features  how the values are spread
places          an order or a frequency                waves        the waves of lines
regression      lines of a stretch by least squares    smeared      lines of an angle that was not measured
bands           the spectrum beside the lines          turning      a run that turns back, block by block
refilled        lines through moments without signal    saturated    hits that reached the converter's limit
features        the numbers of a run that are compared
stretch_lines   lines of one stretch                    route        where a line of a model shows
peaks           lines that no model asked for          lines_left   the same in passes
side_lines      peaks that an uneven speed explains    combs        lines that are impacts' multiples
smeared_orders  lines too wide for a peak              common_tones   tones of one speed that pass for orders
order_or_fixed  what a line of one speed may be        steady_tone  whether it sounds all along
hum             where the mains stands                 impacts      beats of a ringing band
copied          samples written twice                  without_tones   a run less its lines of fixed frequency
short_spectra   how a spectrum changes in time         gain_moments   all of it by one factor
sweeps          lines that sweep at a steady speed     kernel       their compiled loop
moments_of      where something goes on, from flags
flights         flanks that part and meet              near_zero    how long the torque stays near zero
angle_jumps     a measured angle that jumps            flights_beyond_lines   flights that no waves make
as_well_known   a simulated run with its angle known no better than the recording's
mean_steps      a mean that steps and stays            telegraph_noise   a zero that jumps between two levels
strong_alias    a tone that hides faults of samples    under_hum    a limit behind which a hum was picked up
under_noise     a limit behind which it is noisy       strong_hum     a hum that hides them
flat_tops       where a reading stops at a limit
sweep_course    a sweep's ends, and a run without it   flight_statistics   what flights tell of the gap
kept            worked out once for all models         robust_spread   how far values scatter
orders_standing_out   whether lines stand at some orders
sample_jumps    from one sample to the next            tone_frequency  by all runs together
spread_heights  the power of a hertz or two over that on both sides
notches         narrow ones that all runs have at one frequency
held_samples    renewed more seldom than written       leakage      of slow noise into fast lines
pulses_both_ways   in how many pulses a turn a load comes
from_zero       a run whose zero has not drifted
own_factor      how far off the set-point of one moving run is
slips           blows of what lets go under load and grips again
"""
