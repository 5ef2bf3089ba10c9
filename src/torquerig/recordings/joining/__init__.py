"""Columns of several rates, or of several files of one run, as one recording.

================ ==============================================================================
``track``        one column with its rate and start
``tracks``       columns with a rate and a start of their own, from one file
``resampling``   a track at the times of a common grid, without aliases
``alignment``    the shift of two files, by their clocks or by a channel that both have
``join``         all tracks as one recording
================ ==============================================================================
"""
