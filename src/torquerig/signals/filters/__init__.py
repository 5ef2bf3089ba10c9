"""What takes disturbance out of a recorded torque, one filter per file; each is a stage: Recording in, Recording out.

ideal_bandstop       brick-wall notches at the lines' set-point frequencies (the seed's own filter)
notch_bank           second-order notches at the lines, without delay or causal
butterworth          zero-phase low-pass
moving_mean          rolling mean kept aside while other stages work, then put back
revolution_mean      mean over whole turns of the output shaft
harmonic_regression  fitted sines of the lines, following the motor's angle, subtracted

What they stand on:
biquads              cascades of second-order sections, causal or both ways, with quiet edges; biquad_stream: in pieces
kernel               the compiled loops
"""
