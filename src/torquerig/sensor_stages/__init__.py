"""Effects of the sensor and its electronics on a signal, one per file; each is a stage: Recording in, Recording out.

In the measuring body
    characteristic   gain error, nonlinearity      hysteresis   the reading lags behind a torque that turns back
    scale_and_zero   true scale, constant zero
    gain_ripple      gain that varies with an angle or with time
    speed_course     torque that follows the speed by no law
    crosstalk        bending read as torque               ringing      impacts of a bearing
In the electronics
    amplifier        the analog low-pass                  tone         mains hum, pulse-width modulation
    drift            drift of the zero                    noise        white noise of the sensor
    band_noise       noise of a fixed band
    clip             saturation                           dropout      loss of the signal
    converter        range and codes                      rounding     coarser codes
Not on the torque
    encoder          the counts of an incremental encoder on the motor
"""
