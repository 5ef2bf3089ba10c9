"""The answer in words, tables and pictures.

sentences   verdict and remarks          first_screen   what a reader sees first      page   all of it as HTML
tables      findings, limits, errors     model_figure   recording, nominal and completed model
"""
