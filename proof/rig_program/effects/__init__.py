"""What the nominal model leaves out: one effect per file, each with what it does and how it is drawn.

- ``effect``             what an effect can lay its hand on; from which rig and plan it is drawn
- ``visible``            from which size on a line can be seen

Classes that a diagnosis should name:

- ``gear_mesh``, ``commutation_ripple``, ``cogging``, ``blade_pass``, ``bearing_defect``   locked to an angle
- ``torsional_mode``, ``backlash``, ``stribeck_friction``, ``quadratic_drag``              in the mechanics
- ``mains_interference``, ``pwm_aliasing``, ``sensor_bandwidth``, ``sensor_drift``, ``clipping``,
  ``quantization``, ``signal_dropout``                                                     in sensor and cable

In no library, so that "unexplained" is the right answer:

- ``linear_chirp``, ``noise_band``, ``telegraph``, ``gain_jump``, ``tone_bursts``, ``time_base_jump``   in the signal
- ``jumping_line``, ``hardening_shaft``, ``load_step``, ``intermittent_slip``                           in the mechanics
"""
