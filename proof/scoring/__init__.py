"""What a set of diagnoses is worth against the sealed answers.

- ``claims``       what a diagnosis says, read from its JSON
- ``outcome``      right, right within the class, partly, unexplained, missed or a false name: case by case
- ``bounds``       one-sided exact bounds of a share
- ``parameters``   errors of the named effects' parameters, and whether the interval covers the truth
- ``improvement``  held-out misfit before and after, and of the oracle
- ``calibration``  is a confidence of 0.9 right nine times in ten?
- ``trial``        one case with its answer, its diagnosis and its outcome; a folder of them
- ``summary``      all of it as numbers
- ``lines``        the numbers told at the terminal
"""
