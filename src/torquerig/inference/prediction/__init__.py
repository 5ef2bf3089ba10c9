"""What a rig is expected to show in the features of a run, by its linear twin.

rig_lines       lines in each segment of a run             line_features  what they leave in the features
skirts          what lines that sway lose to their sides    phase_modulation   the same where the sway has a period
line_routes     in which feature a line of the rig shows        slow_torque    covariance of the levels
measuring_chain noise, cross-talk and the logger's low-pass     ringing        modes rung by impacts
slow_lines      lines in levels, where no block removes them    wound_up       dry torque after a reversal
swayed_response lines that a wandering speed takes through a resonance
line_phases     phases of the rig's lines as measured in a run
gap_change      what gaps change, by simulated runs
expected_run    lines, bands and levels of one run         kept_twin      answers of a twin that are asked for again
"""
