"""What a changed rig would record: the numbers of ``simulate``, ``filter`` and ``size``, for a page that shows them.

========================= =============================================================================
``question``              a scenario's text with changes: motor, gearbox, numbers, filter chain
``asked``                 the engine of the process that computes
``engine``                the answers, with what was computed for the last questions kept
``answer``                what is shown: errors, lines with causes, sizing, plots
``plots``                 curves, ranges and lines of torque over time and spectrum
``plot_items``            the Bokeh plots that they are drawn in
``quick_curve``           samples of a curve as text that a page unpacks in some milliseconds
``changeable``            which numbers of a scenario a page offers to change
``taken_over``            the changes as edits of the scenario file
========================= =============================================================================
"""
