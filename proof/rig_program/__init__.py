"""A wear rig written from the text of the reference rig alone, independent of the simulator that it tests.

- ``nominal``       the figures of the reference rig and how far a real one may lie from them
- ``true_rig``      one real rig, drawn around the nominal
- ``laws``          what this rig does differently from any simulator: friction, contact, load shape, integrator
- ``plan``          the runs that are recorded
- ``speed``         the course of the speed set-point
- ``load``          the torque of the bed on the wear part
- ``waves``         lines of whole orders as tables over one turn
- ``machine``       the numbers that the compiled loop takes
- ``kernel``        the equations of motion, compiled
- ``stepping``      the rules by which they are stepped
- ``transfer``      the same equations at one frequency: how large a line is, and what it stands out of
- ``forcing``       what acts on the machine sample by sample
- ``sensor_chain``  noise, converter and encoder
- ``recording``     one run, recorded
- ``writing``       Parquet and sidecar
- ``effects``       what the nominal model leaves out, one effect per file
- ``effect_draws``  which effects there are, which hide each other, which plan shows them
- ``gap_shows``     whether any recording shows a gap
- ``draw``          one case: rig, laws, plan and effects
"""
