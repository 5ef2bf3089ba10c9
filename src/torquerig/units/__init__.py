"""Written quantities in SI, and units in every spelling.

============== ===============================================================================
``table``      the units of data sheets by kind of quantity
``spellings``  the symbols of a unit in any order, separator and spelling
``meaning``    what a spelled unit means: kind of quantity and SI value
``quantity``   a written quantity in SI, with the remedy for a faulty one
``remedies``   both readings of an ambiguous quantity
``sensible``   the smallest and largest sensible size of each kind
============== ===============================================================================
"""

from torquerig.units.meaning import Meaning, kind_of, meanings
from torquerig.units.quantity import in_unit, parse_quantity, si_unit, unreasonable, with_unit, written_quantity
from torquerig.units.table import IN_A_LINE, UNITS

__all__ = [
    "IN_A_LINE", "UNITS", "Meaning", "in_unit", "kind_of", "meanings", "parse_quantity", "si_unit", "unreasonable",
    "with_unit", "written_quantity",
]  # fmt: skip
