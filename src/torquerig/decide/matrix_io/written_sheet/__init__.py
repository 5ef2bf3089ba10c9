"""Decision sheets as people write them, read by their shape.

================= ==========================================================================================
``reading``       a workbook or CSV file as tables, with what was understood
``grid``          the cells of one sheet; ``words``: names of lines (weight, datum, sum, ...)
``block``         the largest block in which every value has two names; ``orientation``: criteria down or across
``column_checks`` refuses texts with ratings in them, and weights under another name
``lines``         which rows are criteria and totals, which columns alternatives, weights and datum
``ratings``       marks or points, method and scale; ``weights``: fractions, per cent, products
``totals``        written results compared with computed ones; ``understood``: the sentences
================= ==========================================================================================
"""
