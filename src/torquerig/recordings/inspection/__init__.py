"""What stands in a recording, block by block: each file summarises a stretch, and two summaries join to one.

levels       count, mean, spread, extremes
runs         runs of one value, and of samples that are no numbers
extremes     how often the outermost values come: clipping
outliers     single samples that stand out (spikes), stretches that drop to a level and come back (dropouts)
histogram    how often each level comes, whatever the range turns out to be
course       lowest and highest value over time, for the picture
mean_power   the averaged spectrum
look         all of that for a whole recording, in one pass
recording_info  what a recording holds and what looks suspicious
"""
