"""Data of other programs, in and out: Asset Administration Shells (IDTA 02021) and OPC UA Powertrain.

- ``untrusted``          bytes, archives and XML of files that others wrote, within limits
- ``shell_tree``         the submodels of a shell, from JSON, XML or an AASX package
- ``sizing_project``     what IDTA 02021 says of a drive: motion, load, surroundings, components
- ``sizing_submodel``    a sizing as a submodel of IDTA 02021
- ``shell_file``         a shell as JSON or AASX
- ``gear_attributes``    the gear fields of OPC UA Powertrain as a gearbox entry, and back
"""
