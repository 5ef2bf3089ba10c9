"""JSON Schemas of the files that torquerig reads and writes, derived from the classes that read and write them.

=================== ==============================================================================
``generator``       JSON Schema of a class: numbers with units, uncertain numbers
``catalog_files``   motors, gearboxes, sensors, couplings, classes
``scenario_file``   scenarios: sections, parts and effects by their kind
``other_files``     sidecars, matrices, published tables, filter chains, mixtures, faults, plans
``json_outputs``    what ``--json`` of the commands writes
``named``           all schemas by name
=================== ==============================================================================
"""
