"""Other readings of the same samples: with a fact of the set-up corrected that contradicts the recordings.

best_reading     the one that the nominal rig explains best
reading          runs, features and fit of a reading, and its faults
sensor_scale     another scale of the sensor          sensor_sign   the other sense
clock            another sample rate, other counts, other set-points     induction_slip
other_teeth      another pair of teeth in a stage     teeth         the pairs of a rig
volts            a recording in the sensor's volts, whatever its unit
conditions       what a sidecar does not state of a run: occupancy, course of the speed
order_comb       how well lines at given orders agree with whole runs
"""

from torquerig.inference.readings.best_reading import best_reading
from torquerig.inference.readings.clock import SET_POINT_ERROR
from torquerig.inference.readings.reading import Reading, SetupFault

__all__ = ["SET_POINT_ERROR", "Reading", "SetupFault", "best_reading"]
