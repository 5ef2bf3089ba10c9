"""The referee: sets of trials on the fleet, diagnosed by the command ``torquerig diagnose``, and their scores.

- ``sets``       which cases a set has, and how each is drawn
- ``making``     recordings, scenario and sealed answer of a case
- ``diagnosing`` the command on one case, with a time limit
- ``running``    cases on the case engine: stored, resumed, any number of workers
- ``claims``     what a diagnosis says, read from its JSON
- ``judging``    one case: claim against answer
- ``figures``    figures of a set with exact bounds
- ``page``       the page of a round, Markdown and HTML, and the verdict of every case as CSV
- ``command``    ``python -m proof fleet``
"""
