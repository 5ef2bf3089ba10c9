"""What can be bought: motors, gearboxes, torque sensors and couplings, one YAML file each, with evidence.

- ``entry``     what all entries share: a name, a title, notes, and counts that must be whole
- ``motor``     the schema of a motor file; ``ripple`` its torque ripple
- ``gearbox``   the schema of a gearbox file
- ``sensor``    the schema of a torque sensor file
- ``coupling``  the schema of a coupling file
- ``reading``   ``load_catalog(*folders)``: the ``Catalog``, looked up by name or alias
- ``shipped``   where the catalogs and scenarios lie that come with torquerig
- ``drawing``   ``drawn(entry, seed)`` and ``nominal(entry)``: numbers for a simulation, and which of them were assumed
- ``lines``     the ripple lines of a drawn motor: order, size, and what the size follows
- ``phases``    the phases of a drawn motor: R, L, flux linkage, back-EMF, DC link
- ``table``     the rows of ``torquerig catalog``
"""
