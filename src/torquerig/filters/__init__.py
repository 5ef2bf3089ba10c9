"""Filters that remove disturbances from a recorded torque, one per file; each is a stage: Recording in, Recording out.

ideal_bandstop       brick-wall notches at the lines' set-point frequencies (the filter of the reference report)
notch_bank           second-order notches at the lines, zero-phase or causal
comb                 everything periodic with a line's period but the mean, zero-phase or causal
butterworth          Butterworth low-pass, zero-phase or causal
fir_low_pass         FIR low-pass (Kaiser window), zero-phase or causal
hampel               spikes replaced by the median of their neighbours (Hampel filter)
moving_mean          other stages applied to the deviation from the moving mean
revolution_mean      mean over whole turns of the output shaft
order_bandstop       narrow bands around the lines, over the motor's angle
weighted_lines       least-squares sines, each subtracted with a weight by its level above the load
vold_kalman          Vold-Kalman order tracking filter
synchronous_average  the mean turn of the output shaft, subtracted
adaptive_canceller   adaptive sines over the motor's angle (LMS): causal
harmonic_regression  least-squares sines over the motor's angle, subtracted
load_inverse         the load at the wear part, by the inverse of the rig's response (Wiener filter)

Building blocks:
biquads              cascades of second-order sections, causal or zero-phase; biquad_stream: piece by piece
edge_states          initial states of notches at the edge of a recording
block_regression     joint least-squares amplitudes of lines in long blocks; line_weights: their weights
selected_bins        a few bins of a long signal's spectrum
kernel               the compiled loops of cascades and medians
load_response        frequency response of the rig from load to sensor

Application:
chains/              filter chains: filters in order under one name, and their YAML
block_filtering      filter chains on long recordings, block by block; reach: the overlap that a stage needs
filter_effect        standard deviation, mean, energy and line levels before and after; joined_effect: of blocks
evaluation/          placebo test, step response, hits, delay, bands
"""
