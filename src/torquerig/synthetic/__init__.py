"""Test signals whose every part is known, to judge filters and diagnoses by.

control_signal   every frequency from 0 to half the sample rate at equal amplitude
sweep            a sine that runs through a span of frequencies
timeline         when and at what angle the samples of a mixture are taken
components       what a mixture is made of, one class each, as YAML writes them
mixture          a description -> a recording with every component as a channel of its own; description reads the YAML
simulated        the same for a scenario: what each stage and each mechanism adds to a reading
pairs            a mixture -> its load alone and its noise alone
grid             rounding that makes sums exact
"""
