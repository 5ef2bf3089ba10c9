"""Rigs whose motion was measured: what the motion takes, against what the model would take for the same motion.

No speed loop, no torque sensor: each recording's own angle or position is imposed on the model, in turns or in a line,
and the torque, force or current that this takes is compared, sample by sample, in simulations.

moved        a run made ready: effort, motion, what fits may see       predicted  the effort, by simulation
fitted       numbers of a rig that come nearest                        evidence   what a fit is worth
lines        periodic in the angle or fixed in frequency               neutral    such a line modelled without a name
friction     dry friction, by direction, with a peak, presliding        gap        play in a gear or link
cogging      lines of slots and magnets                                hum        the mains in the channel
others       drag, drift, a branch: the rivals                         tried      hypotheses fitted, kept, refused
completing   the best hypothesis, and again                            objections what speaks against one that gains
convincing   whether a gain speaks for its mechanism                   places     what still stands out, where
level        where over the speed the mean is wrong                    course     what comes again at a place
steps        a moment at which the mean changes                        told       a finding in the contract's words
effort_samples  a limit, moments without signal             effort_told    what is told of them, and of codes
hum_of_a_run    the phase of a hum in each run              goes_with      a delay, or what changes along the runs
believed     not what hardly foretells better, where the model stays wrong
set_aside    why the others were not named
diagnose_motion   all of it in order
"""
