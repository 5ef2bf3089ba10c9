"""The functions of ``import torquerig as tr``: one file each for what a script or notebook does.

======================== ==========================================================================
``scenarios``            ``read_scenario``: a rig from its scenario file
``recording_files``      ``read``, ``write``: recordings from and to files
``simulated``            ``simulate``: what the sensor of a rig records
``filtered``             ``filter``: a recording through a filter chain
``spectral_lines``       ``order_lines``: the lines of a recording and their causes
``comparison``           ``compare``: motors, gearboxes and filters of a study, ranked
``recording_diagnosis``  ``diagnose``: which physics a scenario leaves out
``drive_size``           ``size``: whether motor, gearbox and sensor are large enough
``drive_duty``           ``duty``: how hot a motor becomes over a duty cycle
``rig_modes``            ``modes``: modes of a rig and margins of its speed loop
``decision_matrix``      ``matrix``: elimination, Pugh and Kesselring of one's own matrix; ``matrix_tables``: of a sheet
``result``               what all results have: table, JSON, picture
``inputs``               paths and values as these functions take them
======================== ==========================================================================

Results are frozen values. Their pictures come from ``torquerig.reporting``, which is imported when one is drawn.
"""
