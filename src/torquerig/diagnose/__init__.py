"""Backwards: where recordings and model differ, which physics was left out, and how much better the model gets.

Looking
    shaft_angle     the motor's angle of each run          observed     a run made ready to compare
    sample_faults   coarse codes, flat tops, dropouts      regression   lines of a stretch by least squares
    places          an order or a frequency                features     the numbers of a run that are compared
    peaks           lines that no model asked for          lines_left   the same in passes
    side_lines      peaks that an uneven speed explains    combs        lines that are impacts' multiples
    order_or_fixed  what a line of one speed may be        steady_tone  whether it sounds all along
    impacts         beats of a ringing band                smeared      lines of an angle that was not measured
    flights         flanks that part and meet              near_zero    how long the torque stays near zero
Expecting
    transfer        shafts to reading, on a grid           twin         lines and load spectrum of a rig
    quasi_static    slow torque                            winding      the same near standstill
    kernel          its compiled part                      added_signals  tones, drift and rings of the electronics
    rounding_noise  what coarse codes add                  skirts       what a shaken speed puts beside lines
    expectation     all features of a run                  misfit       how far they lie apart
Fitting
    knobs           what may be turned                     calibration  the nominal model with its numbers fitted
    least_squares   steps whose derivatives are kept
    case            where a diagnosis stands               hypotheses/  how each mechanism would explain what is left
    search          the hypotheses fitted, best first      loaded_part  which part the load acts on
    gap_trial       a gap, which no linear twin has        correction   what it changes in the features
    motion/         rigs whose motion was measured: no loop, no random load, so sample by sample
Deciding
    findings        effect after effect                    revising     each looked back at beside the others
    neutral/        descriptions that compete with names   hum          where the mains stands
    explained       what of a mismatch went                equivalence  rivals that cannot be told apart
    next_run        which run would tell                   candidate_runs  the menu of runs
    set_aside       what was not fitted, and why           leftover     where a model is significantly wrong
    held_out        how well no fit's data are predicted   comparison   both models beside the recordings
    whole_fit       whether a model fits as a whole        convincing   when an effect may be named
    comparison_curves  its curves                          confidence   how sure a finding is
    null_table      least gains from clean rigs, by the scenario's content
    diagnose        all of it in order                     diagnosis    the outcome, and its JSON
"""
