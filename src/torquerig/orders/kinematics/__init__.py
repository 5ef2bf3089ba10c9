"""The order lines that follow from the design of a motor and its gears.

======================= ===========================================================================
``kinematic_lines``     lines of a motor and gearbox: orders, harmonics and causes
``teeth``               ratio and mesh order of a gear stage; ``teeth_reading``: its YAML
``planetary_assembly``  which planetary sets can be assembled
``belt``                ratio and orders of a belt drive
``coincidences``        lines on multiples of the mains or of equal order, and a better test speed
``order_report``        all of that for one drive; ``order_report_text``: as text
======================= ===========================================================================
"""
