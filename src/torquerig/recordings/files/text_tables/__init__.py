"""Text tables as loggers, Excel and MATLAB write them: where the table is, what its columns hold, and its numbers.

================ ================================================================================
``source``       the file as UTF-8 lines: encodings, line ends; ``bounded_gzip``: compressed text
``lines``        the lines at the top
``cells``        numbers, missing values and words; decimal signs and thousands separators
``stamps``       dates and times of day, converted to seconds; ``stamp_parts``: one of them
``written_dates`` dates that are one number
``block``        the rows: separator and columns that stay the same over the most lines
``header``       the lines of names and units above the rows
``scale_rows``   rows of factors and offsets below the names
``preamble``     the sample rate and the units that lines above the names state
``layout``       all of these together
``columns``      which columns are read, and why the others are not
``footer``       the lines below the rows
``parsing``      rows to numbers, with the line of a faulty one
``table``        the whole table, in pieces
================ ================================================================================
"""
