"""Matrices in and out: YAML, Excel sheets, published tables, and their text for the terminal.

======================= ===========================================================================
``opened``              any file with a matrix or tables; ``written_sheet``: sheets as people write them
``written_values``      numbers, weights and Pugh marks as people write them
``matrix_file``         a user's matrix from YAML; ``matrix_schema``: its keys; ``matrix_cells``: its cells
``matrix_sheet``        the same from an Excel sheet; ``excel_layout``: where its cells are
``matrix_writing``      a matrix as YAML
``published_tables``      published tables from YAML; ``sheet``: one such table
``recompute``           the three engines run over the cells of a published table
``computed_sheets``     computed tables in the form of published ones
``workbook_tables``     the tables of an Excel workbook with their formulas
``text``                charts and matrices as text; ``printed_text``: published tables; ``certainty_text``
``matrix_report``       the whole text of ``torquerig matrix``
======================= ===========================================================================
"""
