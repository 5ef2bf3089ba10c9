"""Results as pages, tables, workbooks and text. Lays out results, computes nothing.

====================== ============================================================================
``study/``             the report of a study: page, CSV tables, text for the terminal
``diagnosis/``         the page of a diagnosis
``matrix/``            a matrix as page and Markdown
``sizing/``            a sizing and its duty cycle
``workbook/``          Excel workbooks of a study and of a matrix
``reference_report/``  results and decision of the reference report next to the simulated rig
``moving/``            plots and matrices that a reader moves in the page
``figures/``           pictures of signals, spectra, orders, modes, rankings
``file_schemas/``      JSON Schemas of the files that torquerig reads and writes
``json_results/``      what ``--json`` of each command writes
``layout``             tables of a page; ``html``: a page from its template
``pdf``                a page printed by a headless browser
``replaced_folder``    replacement of a folder in one step
====================== ============================================================================
"""
