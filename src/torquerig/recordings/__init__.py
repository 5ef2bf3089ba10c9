"""What was recorded: channels with units, the run they were taken in, the files they come from, and faults of samples.

=================== ===============================================================================
``recording``       equally sampled channels of one run
``run``             the test conditions of a run; ``set_point``: the speed that they state, over time
``profiles/``       how that speed runs: steady, ramp, reversal, duty cycle, table
``files/``          recordings in and out of every format
``inspection/``     what a recording holds: levels, runs, spikes, dropouts, spectrum, in one pass
``repair/``         faults of samples, by the samples alone: found, described in a sentence, and repaired
``stage``           the one verb of sensor stages and filters: Recording in, Recording out
``channel_angle``   the angle of an angle channel, counts unwrapped and smoothed
``replay``          a recorded torque or motion as the input of a simulation
``spectrum``        amplitude spectra
=================== ===============================================================================
"""
