"""What a rig is expected to show in the features of a run, by its linear twin.

line_routes     in which feature a line of the rig shows        slow_torque    covariance of the levels
expected_run    lines, bands and levels of one run
"""
