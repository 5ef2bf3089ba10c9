"""Backwards: where recordings and model differ, which physics was left out, and how much better the model gets.

In the order in which rooms may use each other:

linear/      loads near standstill
looking/     what recordings show                       expecting/   what a model says that they should
fitting/     turning a model's numbers until it fits    case         where a diagnosis stands
hypotheses/  how each mechanism would explain what is left          neutral/  descriptions that compete with names
diagnosis    the outcome, and its JSON                  judging/     how good a model is
choosing/    which effects complete the model           advising/    what to measure next
opening      from recordings to a case                  findings     effect after effect
beginning    the case that a search begins with, of the rig that fits where a catalog leaves counts open
diagnose     all of it in order
motion/      rigs whose motion was measured, sample by sample       showing/  what a report shows

Next to them: ``set_points`` (does a run turn as its sheet states), ``sheet_ratio`` (does a sheet state another gear
ratio than the lines), ``sample_findings`` (faults of samples as effects),
``own_gap`` (one that a scenario states itself), ``free_names``, ``sentences``, ``null_table`` (least gains from
clean rigs, by the scenario's content). Angles, places, regression, knobs and the linear twin are those of the second
engine: ``inference`` and ``linear_twin``.
"""
