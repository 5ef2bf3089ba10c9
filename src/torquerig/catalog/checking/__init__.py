"""What an entry leaves open, what that costs a decision, and what contradicts.

- ``figures``         figures of a motor or gearbox that decide, from its values
- ``contradictions``  printed values that cannot hold together
- ``costs``           the range of each figure over each open value
- ``draft``           a commented file with blanks for a new entry
- ``entry_check``     all of it for one file
"""
