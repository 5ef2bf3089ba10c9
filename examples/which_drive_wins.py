"""
Which alternative wins, and how sure is that?
=============================================

A decision matrix with missing facts. A missing cell is the whole scale, so totals are ranges.
"""

import torquerig as tr

result = tr.matrix("matrix_example.yaml")
print(result.summary())
print(result.ranking.to_string(index=False, float_format="%.3g"))

# %%
# The value profile: points by criterion.

figure = result.plot()
