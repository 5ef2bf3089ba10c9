"""Rigs whose motion was measured: what the motion takes, against what the model would take for the same motion.

No speed loop, no torque sensor: each recording's own angle or position is imposed on the model, in turns or in a line,
and the torque, force or current that this takes is compared, sample by sample, in simulations.

moved        a run made ready: effort, motion, what fits may see       predicted  the effort, by simulation
fitted       numbers of a rig that come nearest                        evidence   what a fit is worth
lines        periodic in the angle or fixed in frequency               neutral    such a line modelled without a name
friction     dry friction, by direction, presliding                    gap        play in a gear or link
cogging      lines of slots and magnets                                others     drag, drift, a branch: the rivals
completing   the best hypothesis, and again                            places     what still stands out, where
level        where over the speed the mean is wrong                told       a finding in the contract's words
set_aside    why the others were not named
diagnose_motion   all of it in order
"""
