"""Commands below ``torquerig catalog``: new, check, import, export."""
