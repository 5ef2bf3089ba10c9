"""Replacements of branches, whole numbers and indices that work for one rig and for vectors of eight rigs.

Each is a plain function for one number, as it stands, and what the compiler puts in its place.
"""

from __future__ import annotations

from inspect import signature
from math import floor as whole
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.extending import lower_builtin, type_callable
from numba.np.arrayobj import make_array

from torquerig.simulation.kernel.lanes import LANES, call_llvm, lanes, mask, place


def where(condition, yes, no):
    """Return ``yes`` where the condition holds, else ``no``; both are computed."""
    return yes if condition else no


def any_of(condition):
    """Return whether the condition holds for a rig at all: what ``if`` may ask."""
    return bool(condition)


def floor(x):
    """Return the largest whole number not above ``x``, as a float."""
    return float(whole(x))


def two_to(n):
    """Return 2 to the power of a whole number from -1022 to 1023."""
    return 2.0**n


def lookup(values, start, offset):
    """Return the item ``start + offset`` of an array, each rig by its own offset (a whole number, as a float)."""
    return values[start + int(offset)]


def hand_out(kept, row, column, value):
    """Write ``value`` into the row and column of ``kept``, shape (rigs, rows, columns): to each rig its own."""
    kept[0, row, column] = value


def _compiled(function, typing):
    """Teach numba to put the decorated code in the place of ``function``; ``typing`` gives its signature."""

    def teach(code):
        type_callable(function)(lambda context: typing)
        lower_builtin(function, *[types.Any] * len(signature(typing).parameters))(code)
        return code

    return teach


def _where_typed(condition, yes, no):
    truths = isinstance(yes, types.Boolean) or yes == mask
    one, many = (types.boolean, mask) if truths else (types.float64, lanes)
    kind: Any = many if condition == mask else one
    return kind(condition, kind, kind)


@_compiled(where, _where_typed)
def _where(context, builder, sig, args):
    return builder.select(*args)


def _any_of_typed(condition):
    return types.boolean(condition)


@_compiled(any_of, _any_of_typed)
def _any_of(context, builder, sig, args):
    if sig.args[0] != mask:
        return args[0]
    bits = builder.bitcast(args[0], ir.IntType(LANES))
    return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))


@_compiled(floor, lambda x: x(x))
def _floor(context, builder, sig, args):
    return call_llvm(builder, "llvm.floor", args[0])


@_compiled(two_to, lambda n: n(n))
def _two_to(context, builder, sig, args):
    """Write the number into the exponent."""
    vector = sig.args[0] == lanes
    integer = ir.VectorType(ir.IntType(64), LANES) if vector else ir.IntType(64)
    bias, at = (ir.Constant(integer, [one] * LANES if vector else one) for one in (1023, 52))
    return builder.bitcast(builder.shl(builder.add(builder.fptosi(args[0], integer), bias), at), args[0].type)


@_compiled(lookup, lambda values, start, offset: values.dtype(values, types.int64, values.dtype))
def _lookup(context, builder, sig, args):
    double, integer = ir.DoubleType(), ir.IntType(64)
    data = builder.bitcast(make_array(sig.args[0])(context, builder, args[0]).data, double.as_pointer())
    offsets = _each(builder, sig.args[2], args[2])
    found = []
    for lane, offset in enumerate(offsets):
        row = builder.add(args[1], builder.fptosi(offset, integer))
        item = builder.add(builder.mul(row, ir.Constant(integer, len(offsets))), ir.Constant(integer, lane))
        found.append(builder.load(builder.gep(data, [item])))
    together = ir.Constant(args[2].type, ir.Undefined)
    for lane, value in enumerate(found):
        together = builder.insert_element(together, value, place(lane)) if len(found) > 1 else value
    return together


@_compiled(hand_out, lambda kept, row, column, value: types.none(kept, types.int64, types.int64, value))
def _hand_out(context, builder, sig, args):
    array = make_array(sig.args[0])(context, builder, args[0])
    _, rows, columns = cgutils.unpack_tuple(builder, array.shape)
    at = builder.add(builder.mul(args[1], columns), args[2])
    for value in _each(builder, sig.args[3], args[3]):
        builder.store(value, builder.gep(array.data, [at]))
        at = builder.add(at, builder.mul(rows, columns))
    return context.get_dummy_value()


def _each(builder, kind, value):
    """Return what stands in each lane; of one number, itself."""
    return [builder.extract_element(value, place(lane)) for lane in range(LANES)] if kind == lanes else [value]
