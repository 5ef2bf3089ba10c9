"""Sums over and sines of order lines by the turned angle, at a few operations per sample and line.

ladder     which line's turning unit vector is the product of two others'
sums       sums of a signal times the lines over stretches, and lines put into a signal; what fits them
kernel     the compiled loops
"""
