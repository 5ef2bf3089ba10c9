"""Faults of samples: found by the samples alone, described in a sentence, and repaired; no rig is known here.

=========================== ====================================================================================
``detectors``               the detectors in their order, one list for all commands; ``examination``: what they pass on
                            and their protocol; ``recording_faults``: what they find in one recording by itself
``held_samples``            samples renewed more seldom than they are written
``coarse_codes``            values on multiples of a step wider than the converter's
``sharp_dropouts``          the signal jumps to a level, rests there and jumps back
``rounded_dropouts``        the same behind a low-pass, its edges rounded and noise going on; ``dropout_search``: in
                            blocks, ``common_dropouts``: in several recordings, ``lost_moments``: what is known of
                            them, ``pulse_behind_low_pass`` and ``short_departures``: how they are fitted and found
``clipping``                readings that stop at a limit; ``flat_tops``: exactly, ``clipping_under_hum`` and
                            ``clipping_under_noise``: where a hum, an alias or noise was added behind the limit
``samples_at_limit``        what a limit cut off, rebuilt
``repeated_samples``        samples written twice
``angle_jumps``             a measured angle that jumps
``time_base``               those two and held samples: recordings whose time base is broken
``slips``                   blows of what lets go under load and grips again; ``slips_removed``: without them
``telegraph_noise``         a zero that jumps between two levels
``gain_changes``            moments in which all of the signal is larger by one factor
``mean_steps``              a mean that steps and stays
``sample_jumps``            jumps from one sample to the next, or within half a millisecond; ``edges``: beyond slopes
``sweeps``                  lines that sweep at a steady speed; ``sweep_course``: their ends, and a run without them
``faults``                  what a fault shows, what was repaired, and where it is
``moments``                 moments of a recording: from flags, about jumps, bridged
``strong_tone``             a tone that hides faults; ``mains_hum``: a hum that does
``short_spectra``           how a spectrum changes in time; ``path_sum``: paths through such a map
``robust_spread``           standard deviations that outliers hardly move
=========================== ====================================================================================
"""
