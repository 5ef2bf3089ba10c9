"""Faults of samples that are drawn on purpose, with their truth: one fault per file.

======================== =====================================================================================
``registry``             all faults in their order, and their form in YAML
``drawn_fault``          what a fault is: parameters, the recording with it, the truth
``measured``             what faults disturb: readings, angles, rows and their times; ``moments``: when
of the torque            ``dropouts``, ``spikes``, ``stuck_value``, ``held_samples``, ``repeated_samples``,
                         ``clipping``, ``quantised``, ``hum``, ``alias``, ``sweep_line``, ``drift``,
                         ``telegraph_noise``, ``gain_changes``, ``mean_steps``, ``sample_jumps``, ``slips``,
                         ``wrong_scale``, ``wrong_sign``
of the encoder           ``lost_counts``, ``doubled_counts``, ``wrapped_angle``, ``wrong_counts_per_turn``
of the times             ``late_stamps``, ``coarse_stamps``, ``missing_samples``, ``duplicate_samples``,
                         ``wrong_rate``
======================== =====================================================================================
"""
