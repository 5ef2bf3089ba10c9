"""The version of torquerig."""

__version__ = "0.1.0"
