"""What moves on a page: curves with all their samples, plots, matrices that are computed in the browser.

packed_curve    samples of a curve as text for a page
plot_json       a Bokeh plot as JSON with the same bytes in each run
signal_plot     reading before and after a filter, true load, and error over time
channels_plot   the channels of a recording over time
notebook_page   a recording in a frame of a notebook
spectrum_plot   spectrum before and after a filter with its lines and their causes
matrix_model    the three matrices as numbers that the page computes again
page_scripts    scripts and data written into a page
"""
