"""Scores of diagnoses against the sealed answers.

- ``claims``       verdict and findings of a diagnosis, read from its JSON
- ``outcome``      outcome of a case: right, right within the class, partly right, unexplained, missed or a false name
- ``bounds``       one-sided exact bounds of a share
- ``parameters``   errors of the named effects' parameters, and whether the interval covers the truth
- ``improvement``  held-out residual before and after, compared with the oracle
- ``calibration``  calibration of the confidence
- ``trial``        one case with its answer, its diagnosis and its outcome; a folder of them
- ``summary``      all of it as numbers
- ``lines``        the scores as text for the terminal
"""
