"""Real recordings whose answers are known, through the diagnosis; ``python -m proof.real`` prints the table.

- ``public``   where the originals stand: source, revision, SHA-256; fetched, or read from a folder
- ``emps``     DC motor and ball screw: dry friction, its directions, a ripple over position
- ``laas``     cogging of an 18-slot, 24-magnet motor
- ``brfd``     a banded drum brake: presliding and backlash
- ``figures``  held-out errors of the baseline and of each step
"""
