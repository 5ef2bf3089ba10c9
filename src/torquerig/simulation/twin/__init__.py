"""The linear model of a rig ("twin") for small changes about one operating point; ``linear_twin.twin_of(rig)``.

=================== =============================================================================
``linear_twin``     the linear model with modes, poles, margins, lines and crossings
``operating_point`` steady speeds, torques and slopes, and the effects that are left out
``plant``           the arrays as A, B, C, D; ``system``: named inputs, outputs and states, python-control
``friction_slope``  torque and slope of friction about a steady speed
``loop``            the closed speed loop; ``margins``: gain, phase and modulus margin
``sensing``         the measured speed of a speed loop: encoder and filter
``modes``           frequencies, damping; ``shapes``: mode shapes in words
``lines``           order lines and the inputs at which they act; ``line_inputs``: as phasors
``crossings``       Campbell diagram: crossings of lines and modes
``blocks``          exact recursion, a block of samples at a time; ``kernel``: its compiled part
=================== =============================================================================
"""
