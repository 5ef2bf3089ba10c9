"""Backwards: one likelihood of features, nameless alternatives, held-out data as referee.

sample_faults           samples at a limit, coarse codes and dropouts: named, repaired or left out
untrue_samples          faults of samples that no mechanism makes: repaired and stated; set_points: speeds of sidecars
rig_under_test          whether the recordings can be runs of the rig
motor_angle/            the angle of the motor in each run            places   an order or a frequency
measured_run, blocks    a recording with its angle, cut where the speed changes
kept                    what was computed for a run and is required again
features/               what recordings show: lines, bands, levels; and lines that no model has yet
prediction/             what a rig is expected to show
likelihood              how likely features are under a model      load_spectrum   what nobody knows of a load
discrepancy             how far a right model may be off           model_density   what a model expects between lines
readings/               other readings of the samples: with a fact of the set-up corrected
knobs                   parameters of parts that a fit may change
parameters, fit         the nominal rig's numbers, their maximum of the posterior, and the evidence
climb, slopes           the way to that maximum, derivatives; moved_gain: by one gain; data: features of all runs
shared_orders           the phase between lines of one order
additions/, addition    hypotheses: nameless effects, numbers far off, mechanisms
context, shafts, tones, one_size, gap_width    for them; undecided_lines: orders that may be frequencies
mean_torques            how much of the mean torques a course explains
search                  the additions of the largest posterior odds; dropped: those that later ones make needless
refitted, one_number    a model with fewer parameters; where one of them would be without its prior
adequacy, held_out      whether a model explains the data, and those that no fit has seen
isolability/            what recordings can show and separate
motion/                 rigs whose motion was measured: the likelihood of the samples of the effort
engine                  all of it in order                        answer/   in the form of the contract
"""
