"""Turning a model's numbers until it fits.

misfit       how far features lie apart
calibration    a model with its numbers fitted        least_squares  steps whose derivatives are kept
difference_quotients  several knobs stepped at once   profiled  what another rig would cost, before a fit
"""
