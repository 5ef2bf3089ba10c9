"""Filter chains: stages in order under one name, and how they are written in YAML.

======================= ===========================================================================
``filter_chain``        a chain of stages, and the two chains of the reference report
``chain_file``          reads the chains of a YAML file for one motor and gearbox
``chain_schema``        the YAML of each stage; ``line_stage_schema``: of those that remove lines
``stage_form``          the YAML of a stage in general, with lines named by cause and harmonic
``renamed_chains``      old names of chains, stages and line families, still read
======================= ===========================================================================
"""
