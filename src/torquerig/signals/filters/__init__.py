"""What takes disturbance out of a recorded torque, one filter per file; each is a stage: Recording in, Recording out.

ideal_bandstop       brick-wall notches at the lines' set-point frequencies (the seed's own filter)
butterworth          zero-phase low-pass
moving_mean          rolling mean kept aside while other stages work, then put back
revolution_mean      mean over whole turns of the output shaft
harmonic_regression  fitted sines of the lines, following the motor's angle, subtracted
"""
