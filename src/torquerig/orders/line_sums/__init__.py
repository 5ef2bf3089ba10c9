"""Sums of a signal times the sines of order lines, at a few operations per sample and line.

================== ==============================================================================
``sums``           sums over stretches of a signal, lines added to a signal, Gram matrix of lines
``product_ladder`` which line's unit vector is the product of those of two other lines
``kernel``         the compiled loops
================== ==============================================================================
"""
