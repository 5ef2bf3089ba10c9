"""Forwards: from a rig to a recording.

simulate  the one verb              lower    Rig -> flat arrays       arrays   what the kernel and the twin read
batch     many like rigs at once    ready    a rig ready to step      outputs  what a run keeps
kernel/   the compiled loop         rows     each kind of term
profile   set-point over time       waves    few sine calls           inputs   what is given at every sample
linear    the same arrays as M, C, K twin/    modes, margins, Campbell diagram, python-control StateSpace
drawn_loads  the random loads that a recording ran against, drawn again
true_lines   what lines add to a reading: a second run without what makes them
linear_path  exact and fast where the rig is linear; linear_start  its start; linear_refusals  what it refuses
step_choice  what fixes the step    step_proof  what halving it changes    failure  why a run could not be integrated
"""
