"""Simulation: from a rig to a recording.

=================== =============================================================================
``simulator``       ``simulate``: from a rig, a duration and a random seed to a recording
``batch``           many similar rigs at once
``lower``           from a rig to flat arrays; ``arrays``: the arrays; ``term_kinds/``: each kind of term
``ready``           a rig prepared for integration; ``inputs``: set-points and loads at every sample
``sampling``        sample rate and settling time where nothing else is stated
``profile``         set-point over time; ``waves``: cosines of a rig; ``outputs``: outputs of a run
``condensation/``   modes far above the recorded band left out, with the error in the band
``kernel/``         the compiled loop
``step_choice``     integration steps per sample; ``step_watch``: check during a run; ``step_proof``: of all of it
``effort``          limits of a run; ``motor_limit``, ``loop_stability``: what is said of motor and loop
``failure``         the cause of a failed integration
``linear``          the same arrays as M, C, K; ``twin/``: linear model, modes, margins, Campbell diagram
``linear_path``     exact simulation of a linear rig; ``linear_start``, ``linear_refusals``: its start and limits
``true_lines``      the disturbance lines in a reading, from a second run without them
=================== =============================================================================
"""
