"""The order lines that follow from the design of a motor and its gears.

======================= ===========================================================================
``kinematic_lines``     lines of a motor and gearbox: orders, harmonics and causes
``teeth``               ratio and mesh order of a gear stage; ``teeth_reading``: its YAML
``stage_kinds``         stages without known teeth, and stages driven from their output
``planetary_assembly``  assembly conditions of planetary sets, and the nearest sets that meet them
``belt``                ratio and orders of a belt drive
``coincidences``        lines on multiples of the mains or of equal order, and a better test speed
``order_report``        lines, coincidences and better speed of one drive; ``order_report_text``: as text
======================= ===========================================================================
"""
