"""What the sensor and its electronics do to a signal, one effect per file.

In the measuring body
    characteristic   wrong gain, bent characteristic      hysteresis   the reading lags behind a torque that turns back
    crosstalk        bending read as torque               ringing      impacts of a bearing
In the electronics
    amplifier        the analog low-pass                  tone         mains hum, pulse-width modulation
    drift            a zero that moves                    noise        white noise of the sensor
    band_noise       noise of a fixed band
    clip             saturation                           dropout      moments without signal
    converter        range and codes                      rounding     coarser codes
Beside the torque
    encoder          the counts of an incremental encoder on the motor
"""
