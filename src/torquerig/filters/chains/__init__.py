"""Filter chains: stages in order under one name, and how they are written in YAML.

======================= ===========================================================================
``filter_chain``        a chain of stages, and the two chains of the reference report
``chain_file``          the chains of a YAML file, made for one motor and gearbox
``chain_schema``        the YAML of each stage; ``chain_line_stages``: of those that remove lines
``chain_form``          how a stage and the lines it names are written
``renamed_chains``      old names of chains and line families, still read
======================= ===========================================================================
"""
