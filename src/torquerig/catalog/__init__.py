"""Catalog of motors, gearboxes, torque sensors and couplings: one YAML file each, with evidence.

- ``entry``     common fields of all entries: name, title, note; integer counts
- ``motor``     the schema of a motor file; ``ripple`` its torque ripple
- ``gearbox``   the schema of a gearbox file
- ``sensor``    the schema of a torque sensor file
- ``coupling``  the schema of a coupling file
- ``reading``   ``load_catalog(*folders)``: the ``Catalog``, looked up by name or alias
- ``shelves``   the ``Catalog``; ``unread`` one that is read at the first look-up
- ``search``    the catalog folders that a scenario or a command reads
- ``shipped``   folders of the catalogs and scenarios that come with torquerig
- ``sampling``  ``sample_entry(entry, seed)`` and ``nominal(entry)``: values for a simulation
- ``lines``     the ripple lines of a sampled motor: order, amplitude, and dependence on load
- ``phases``    the phases of a sampled motor: R, L, flux linkage, back-EMF, DC link
- ``winding``   pole pairs and slots of a motor
- ``table``     the rows of ``torquerig catalog``
"""
