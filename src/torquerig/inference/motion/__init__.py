"""The likelihood of samples where the motion is a measured input.

The effort that a rig needs along the measured motion is compared with the measured one, sample by sample.

imposed_run, lapped      a recording with its motion; its signals in frames and frequencies
needed_effort            the effort of a rig along the motion, by the simulator
density                  the smooth density of coloured residuals (Whittle), estimated with the model
hypothesis, hypotheses/  what may be added: mechanisms, and effects without a name
fit, fitted_model        posterior maximum with Laplace's evidence
held_out                 the density of data that no fit has seen
search, engine           the additions of the largest posterior odds; all of it in order
sizes, parameters_found, answer    in the form of the contract
"""
