"""The answer of a diagnosis in the form of the contract.

document        all keys                              verdict      adequate, missing physics, unexplained, set-up error
effects         findings, nameless effects            confidence   posterior mass of names and classes
setup_facts     facts of the set-up, fitted numbers   numbers      intervals and digits
sizes, rms      effects and errors in N m             held_out_figures   residuals of data that no fit has seen
located         where model and recordings differ     tried        what was rejected, and by how much
owned           numbers of the scenario that belong to a mechanism
stated_numbers  which numbers are stated again        course_axis  over what mean torques differ
significant     what is too large for random errors
isolated        smallest visible sizes, and which further run separates what is alike
"""

from torquerig.inference.answer.document import as_json

__all__ = ["as_json"]
