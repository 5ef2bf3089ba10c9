"""The fleet: a program that draws whole rigs, hides effects in them and records them; it imports nothing of torquerig.

==================  ================================================================================================
``design``          kinds of drive, transmission and load; all stated numbers (``scale``, ``*_stated``)
``stated``          a stated number with its spread; true values; the text of the scenario
``laws``            friction at rest, contact, load shape, controller and noise of a rig
``plans``           runs as people make them
``train``           the equations as arrays; ``kernel`` integrates them; ``settling`` start and step
``courses``         set-point, load and turbulence over time
``chain``           amplifier, noise, converter, encoder, tacho
``rig``             a drawn rig; ``recording`` records and writes it
``response``        what a torque or an angle error makes at the sensor, for the size of an effect
``effect``          what an effect may change; ``effects`` one file per mechanism of the contract
``counting``        likelihood ratio with and without an effect: whether it counts
``draw``            a rig with hidden effects; ``answers`` its sealed answer
==================  ================================================================================================
"""
