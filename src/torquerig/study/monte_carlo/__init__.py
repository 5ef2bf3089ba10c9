"""Thousands of draws of what the catalog leaves open: distribution of each criterion, ranking, and what decides it.

================ =======================================================================================
``drawn_study``  the drives, what is computed of each draw, and the table of cases
``drawn_case``   the figures of a block of cases, by the compiled batch
``distribution`` quantiles of a criterion with their uncertainty by the number of draws
``ranking``      in which share of the draws each combination is best
``running``      draws into a store, and back as tables
``design``       which quantiles a study of sensitivity asks for: Sobol, Morris
``sensitivity``  which open value drives the reading error and the choice
================ =======================================================================================
"""
