"""Test signals with known components, for tests of filters and diagnoses.

control_signal   every frequency from 0 to half the sample rate at equal amplitude
sweep            a sine with a varying frequency
timeline         time and motor angle of the samples of a mixture
components       components of a mixture, one class each
mixture          a description -> a recording with a channel for every component
description      the YAML file of a mixture, and of faults
simulated        the same for a scenario: the contribution of each stage and mechanism to a reading
faults/          faults of samples that are drawn on purpose, with their truth, one per file
base_signal      the mixture that a fault is drawn into where no recording is named
writing          a synthetic recording, with the times that its faults gave to its rows
pairs            a mixture -> its load alone, or its noise alone
grid             rounding that makes sums exact
"""
