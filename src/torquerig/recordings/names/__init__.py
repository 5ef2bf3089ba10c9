"""Names and units of columns as loggers write them, and what they say about a channel.

==================== ==============================================================================
``header``           a header cell, split into name and unit: ``Torque [Nm]``, ``Drehzahl in U/min``
``words``            the words of a name and the quantity that they state, English and German
``channel_units``    the units of channels: those of data sheets, counts, degrees Celsius
``interpretation``   quantity, unit and scale of a column, with the reason, and what is missing
``time_column``      the columns that hold the times, with their units; ``time_pairs``: whose times they are
==================== ==============================================================================
"""
