"""Inspection of a recording block by block: each file summarises a block, and the summaries of two blocks are joined.

==================== =============================================================================
``levels``           count, mean, standard deviation, extremes
``runs``             runs of one value, and of samples that are not numbers
``extremes``         the highest and lowest value and how often they occur: clipping
``outliers``         spikes, and dropouts to one level
``histogram``        histogram over a range that grows with the blocks
``min_max_envelope`` lowest and highest value over time, for the picture
``mean_power``       averaged spectrum
``channel_summary``  all of these for one channel, in one pass
``recording_info``   the summaries of a recording as figures, and suspicious findings in sentences
``stretch_faults``   faults of the samples of a recording's first stretch, as ``recordings.repair`` finds them
==================== =============================================================================
"""
