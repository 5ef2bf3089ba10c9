"""What recordings show, before any model is asked; faults of samples are in ``recordings.repair``.

observed        a run made ready to compare             smeared      lines of an angle that was not measured
bands           the spectrum beside the lines          turning      a run that turns back, block by block
refilled        lines through moments without signal    value_features  how the values are spread
features        the numbers of a run that are compared
stretch_lines   lines of one stretch                    route        where a line of a model shows
peaks           lines that no model asked for          lines_left   the same in passes
side_lines      peaks that an uneven speed explains    combs        lines that are impacts' multiples
smeared_orders  lines too wide for a peak              common_tones   tones of one speed that pass for orders
order_or_fixed  what a line of one speed may be        steady_tone  whether it sounds all along
hum             where the mains stands                 impacts      beats of a ringing band
without_tones   a run less its lines of fixed frequency
flights         flanks that part and meet              near_zero    how long the torque stays near zero
flights_beyond_lines   flights that no waves make      flight_statistics   what flights tell of the gap
as_well_known   a simulated run with its angle known no better than the recording's
kept            worked out once for all models         tone_frequency  by all runs together
orders_standing_out   whether lines stand at some orders
spread_heights  the power of a hertz or two over that on both sides
notches         narrow ones that all runs have at one frequency
leakage         of slow noise into fast lines          from_zero    a run whose zero has not drifted
pulses_both_ways   in how many pulses a turn a load comes
"""
