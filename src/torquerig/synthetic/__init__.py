"""Test signals with known components, for tests of filters and diagnoses.

control_signal   every frequency from 0 to half the sample rate at equal amplitude
sweep            a sine with a varying frequency
timeline         time and motor angle of the samples of a mixture
components       components of a mixture, one class each
mixture          a description -> a recording with a channel for every component; description reads the YAML
simulated        the same for a scenario: the contribution of each stage and mechanism to a reading
pairs            a mixture -> its load alone, or its noise alone
grid             rounding that makes sums exact
"""
