"""TELLING: what a study found as a page, tables, a workbook and plain text. Lays out results, computes nothing.

study_report     the whole report of a study, swapped into its folder in one step
study_page       the page: its sections in order             study_chapters   the matrices' tables of the page
study_tables     the tables of what was simulated            study_answers    question, limits, sources, how to repeat
study_text       ranked table and shares for the terminal    study_csv        every figure of every combination
workbook         the matrices as an Excel file               workbook_sheets  its sheets
workbook_kesselring  the sheet that calculates: weights to change, totals and ranks as formulas
workbook_matrix  a matrix of one's own as an Excel file that is filled in, calculates and is read back
workbook_entries its sheets to fill in               workbook_links   formulas from these to the points
workbook_answers its verdict, open questions, lints
trace_tables     every cell of a study from catalog to points    workbook_trace   the same as two sheets
redone_trace     the same for a decision made again
matrix_files     a matrix as .html, .md, .xlsx, .yaml    matrix_chapters  its chapters, for page and Markdown
matrix_page      its page                                matrix_markdown  its Markdown
strength_figure  the S-diagram                           value_profile    points by criterion, weak spots
layout           what a table is made of                     shades           colour scales whose text stays readable
picture          a matplotlib figure in a page or file       envelope         a long curve drawn with few points
spectrum_figure  amplitude spectrum with lines by cause      signal_figure    a stretch of the reading beside the truth
error_figure     reading error of each drive and filter      shares_figure    load, cogging, electrical, mechanical
rating_figure    technical against economic rating           notch_figure     before and after band-stops, lines marked
modes_figure     Campbell diagram and Bode curves          campbell_figure  order lines against modes
bode_figure      transfers to the sensor, loop gain
redone_page      a published decision made again: page, Markdown    redone_chapters  its chapters
sizing_text      a sizing as rows for the terminal           speed_torque_figure  regions, cycle and ratios of a sizing
duty_figure      a duty cycle: torque, speed, temperatures
seed_page        the seed report's tables and figures beside the simulated rig    seed_figures   its pictures
order_figure     order spectrum, order map, Campbell diagram as measured
judged_figure    original, filtered, both, rolling means
info_figure      a recording at a glance: course, spectrum, levels, what is suspicious
diagnosis_page   the page of a diagnosis                 diagnosis_tables  its tables
diagnosis_words  verdict and places in sentences         diagnosis_pictures  its pictures with captions
diagnosis_causes what stands at each line                diagnosis_spectrum_figure  recording and models over orders
diagnosis_course_figure  slow torque of every run        diagnosis_window_figure  a short window with its lines
diagnosis_residual_figure  what each model leaves        diagnosis_places_figure  shares of the misfit by place
families         colour and name of each family of lines
proof_page       blind trials: page, Markdown                proof_figures    reliability, gains where nothing is hidden
replaced_folder  a folder that is replaced whole or not at all
"""
