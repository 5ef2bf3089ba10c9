"""The lowest and the highest value over time: what a picture of a long signal shows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

COLUMNS = 2000


@dataclass(frozen=True, kw_only=True)
class Course:
    """Extremes of columns of ``width`` samples each, shape (columns,), from sample 0 on; NaN where no number stands."""

    width: int
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    def centres(self) -> NDArray[np.float64]:
        """Return the sample number of the middle of each column."""
        return np.asarray((np.arange(self.low.size) + 0.5) * self.width, dtype=np.float64)


def course_of(values: NDArray[np.float64], *, width: int) -> Course:
    """Return the extremes of ``values``, shape (samples,), in columns of ``width`` samples, the last one shorter."""
    starts = np.arange(0, values.size, width)
    with np.errstate(invalid="ignore"):
        return Course(width=width, low=np.fmin.reduceat(values, starts), high=np.fmax.reduceat(values, starts))


def joined_courses(left: Course, right: Course) -> Course:
    """Return the course of both, where columns are equally wide and ``left`` has only whole ones; 4000 at most."""
    low, high = np.concatenate([left.low, right.low]), np.concatenate([left.high, right.high])
    return thinned(Course(width=left.width, low=low, high=high))


def thinned(course: Course) -> Course:
    """Return the course with pairs of columns merged until there are at most 4000."""
    while course.low.size > 2 * COLUMNS:
        starts = np.arange(0, course.low.size, 2)
        course = Course(
            width=2 * course.width,
            low=np.fmin.reduceat(course.low, starts),
            high=np.fmax.reduceat(course.high, starts),
        )
    return course
