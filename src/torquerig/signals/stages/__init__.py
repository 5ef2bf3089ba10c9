"""What the sensor and its electronics do to a signal, one effect per file.

amplifier   the analog low-pass of the sensor's amplifier
noise       white noise of the sensor
converter   clipping and quantisation by the analog-digital converter
encoder     the counts of an incremental encoder on the motor
"""
