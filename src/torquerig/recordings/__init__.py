"""Recordings: sampled channels with units, the test conditions of the run, files in every format, inspection.

=================== ===============================================================================
``recording``       equally sampled channels of one run
``run``             the test conditions of one run
``set_point``       the set-point of the motor speed at each sample
``profiles/``       set-point over time: steady, ramp, reversal, duty cycle, table
``files/``          reading and writing of recordings in every format
``names/``          headers and units of columns as loggers write them
``joining/``        columns of several rates or files as one recording
``inspection/``     levels, runs of one value, spikes, dropouts, spectrum, in one pass
``repair/``         faults of samples, from the samples alone: found, described in a sentence, and repaired
``stage``           the interface of sensor stages and filters: Recording in, Recording out
``channel_angle``   the angle of an angle channel: unwrapped, counts smoothed
``replay``          a recorded torque or motion as the input of a simulation
``spectrum``        amplitude spectra
=================== ===============================================================================
"""
