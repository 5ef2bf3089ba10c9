"""A rig as a page shows it: the parts of the file along the shaft, and the values that a part may state.

=================== ===========================================================================
``placed_parts``    where each part of a scenario's text is drawn, also of one that has mistakes
``drawing``         the drawing, in which each part can be chosen
``part_values``     the values of a part: stated, from the catalog, or by default
=================== ===========================================================================
"""
