"""What a torque sensor will read, what disturbs it, which drive to buy, and which physics a model left out."""

__version__ = "0.1.0"
