"""Diagnoses of real recordings with known answers; ``python -m proof fleet --real FOLDER`` judges them.

- ``public``   public sources with revision and SHA-256; downloaded, or read from a folder
- ``emps``     DC motor and ball screw: dry friction by direction, a ripple over position
- ``laas``     cogging of an 18-slot, 24-magnet motor
- ``brfd``     a banded drum brake: presliding and backlash
"""
