"""What recordings can tell apart, before and after a diagnosis: from what each hypothesis would change in the features.

probes        lines that a rig may have, for hypotheses that need one     signatures   changes, nuisances projected out
limits        the smallest size of each mechanism that would be found      classes      what has parallel signatures
further_runs  runs that nobody made                                       separating   which of them separates two
beforehand    all of it for the nominal rig, before anything is searched
"""
