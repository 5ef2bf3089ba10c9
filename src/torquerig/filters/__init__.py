"""What takes disturbance out of a recorded torque, one filter per file; each is a stage: Recording in, Recording out.

ideal_bandstop       brick-wall notches at the lines' set-point frequencies (the filter of the reference report)
notch_bank           second-order notches at the lines, without delay or causal
comb                 everything that repeats with a line's period, the mean kept, without delay or causal
butterworth          low-pass, without delay or causal
fir_low_pass         low-pass by a finite window, without delay or causal
hampel               spikes replaced by the median around them
moving_mean          rolling mean kept aside while other stages work, then put back
revolution_mean      mean over whole turns of the output shaft
order_bandstop       narrow bands around the lines, by the motor's angle
weighed_lines        fitted sines, each subtracted by as much as it stands out of the load
vold_kalman          the smoothest amplitudes that explain the torque
synchronous_average  the mean turn of the output shaft, subtracted
adaptive_canceller   sines that learn their amplitude, by the motor's angle: causal
harmonic_regression  fitted sines of the lines, following the motor's angle, subtracted
load_inverse         the load that the reading came from, by the rig's own response

What they stand on:
biquads              cascades of second-order sections, causal or both ways, with quiet edges; biquad_stream: in pieces
edge_lines           the states from which notches start as if their lines had always been there
block_regression     joint amplitudes of lines in long blocks, from those sums; standing_out: of the load
kernel               the compiled loops of cascades and medians

Together:
chains/              filters in order under one name, and their YAML
streaming            chains on recordings too long to be held, block by block; reach: how far their stages look
effect               what a chain did: spread, mean, energy, line levels; effect_joined: from its blocks
evaluation/          what a chain is worth: placebo at empty orders, steps put in, hits, delay, bands
load_response        what a model of the rig says the sensor makes of the load
"""
