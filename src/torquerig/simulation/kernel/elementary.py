"""Sine, exponential and hyperbolic tangent from sums and products alone, for one number and for lanes alike.

The approximations are those of S. L. Moshier, Methods and Programs for Mathematical Functions (Ellis Horwood, 1989), as
in the Cephes library (sin.c, exp.c, tanh.c): errors below 3e-16 of the value, of the sine below 3e-16 of 1.
"""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import any_of, floor, two_to, where
from torquerig.simulation.kernel.fast import FAST

# pi/2 in three parts: the first two have 33 bits, so that their products with a whole number are exact up to 2^20
HALF_PI_1, HALF_PI_2, HALF_PI_3 = 1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21
LN_2_1, LN_2_2 = 6.93145751953125e-1, 1.42860682030941723212e-6


@njit(fastmath=FAST, inline="always")
def sine_cosine(x):
    """Return sine and cosine of an angle [rad], exact to the rounding of the angle up to 1e9."""
    quarter = floor(x * 0.63661977236758134308 + 0.5)
    r = x - quarter * HALF_PI_1
    r = r - quarter * HALF_PI_2
    r = r - quarter * HALF_PI_3
    z = r * r
    z2 = z * z
    sine = (1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z2
    sine = (sine + (2.75573136213857245213e-6 * z - 1.98412698295895385996e-4)) * z2
    sine = r + r * z * (sine + (8.33333333332211858878e-3 * z - 1.66666666666666307295e-1))
    cosine = (-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z2
    cosine = (cosine + (-2.75573141792967388112e-7 * z + 2.48015872888517045348e-5)) * z2
    cosine = 1.0 - 0.5 * z + z2 * (cosine + (-1.38888888888730564116e-3 * z + 4.16666666666665929218e-2))
    turn = quarter - 4.0 * floor(0.25 * quarter)
    odd = (turn == 1.0) | (turn == 3.0)
    first, second = where(odd, cosine, sine), where(odd, sine, cosine)
    return where(turn >= 2.0, -first, first), where((turn == 1.0) | (turn == 2.0), -second, second)


@njit(fastmath=FAST, inline="always")
def exponential(x):
    """Return ``exp(x)``; beyond -700 and 700 it stays as it is there."""
    x = where(x > -700.0, where(x < 700.0, x, 700.0), -700.0)
    n = floor(x * 1.44269504088896340736 + 0.5)
    r = x - n * LN_2_1
    r = r - n * LN_2_2
    z = r * r
    p = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 9.99999999999999999910e-1)
    q = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z + 2.27265548208155028766e-1) * z + 2.0
    return (1.0 + 2.0 * p / (q - p)) * two_to(n)


@njit(fastmath=FAST, inline="always")
def hyperbolic_tangent(x):
    """Return ``tanh(x)``."""
    size = abs(x)
    result = 1.0 - 2.0 / (exponential(2.0 * size) + 1.0)
    result = where(x > 0.0, result, -result)
    small = size < 0.625
    if any_of(small):
        z = x * x
        p = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3
        q = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z + 4.84406305325125486048e3
        result = where(small, x + x * z * (p / q), result)
    return result
