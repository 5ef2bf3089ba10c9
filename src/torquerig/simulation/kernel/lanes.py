"""Vectors of eight numbers as one type, by which the loop integrates eight similar rigs at once.

The functions of this package are written for one number. Numba compiles them for ``float64``, one rig, or for
``Lanes``, a vector of the processor with one rig in each of its places; the arithmetic is the same, a comparison gives
a ``Mask``, and what depends on it is chosen by ``where`` (see ``choice.py``). Arrays of lanes have the rigs along their
last axis.
"""

from __future__ import annotations

import operator
from typing import Any

from llvmlite import ir
from numba import extending
from numba.core import cgutils, types
from numba.core.typeconv.castgraph import Conversion
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin, lower_cast, models, register_model
from numba.np.arrayobj import make_array

# numba states what these take, not what they give
intrinsic: Any = extending.intrinsic
NamedTuples: Any = types.BaseNamedTuple
LANES = 8  # doubles in the widest registers; narrower processors take them in two or four turns


class LanesType(types.Type):
    """Numba's name for eight ``float64`` in one register."""

    def __init__(self):
        super().__init__(name="Lanes")

    def can_convert_from(self, typingctx, other):
        """One number is eight equal ones."""
        return Conversion.safe if isinstance(other, types.Float | types.Integer) else None


class MaskType(types.Type):
    """Numba's name for the eight truth values of a comparison of lanes."""

    def __init__(self):
        super().__init__(name="Mask")

    def can_convert_from(self, typingctx, other):
        """One truth is eight equal ones."""
        return Conversion.safe if isinstance(other, types.Boolean) else None


lanes, mask = LanesType(), MaskType()


@register_model(LanesType)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, dmm, fe_type):
        super().__init__(dmm, fe_type, ir.VectorType(ir.DoubleType(), LANES))


@register_model(MaskType)
class _MaskModel(models.PrimitiveModel):
    def __init__(self, dmm, fe_type):
        super().__init__(dmm, fe_type, ir.VectorType(ir.IntType(1), LANES))


def place(lane):
    """Return the number of a lane as LLVM takes it."""
    return ir.Constant(ir.IntType(32), lane)


def _spread(builder, value):
    """Return a vector that holds ``value`` in every place."""
    empty = ir.Constant(ir.VectorType(value.type, LANES), ir.Undefined)
    first = builder.insert_element(empty, value, place(0))
    return builder.shuffle_vector(first, empty, ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES))


@lower_cast(types.Float, LanesType)
@lower_cast(types.Integer, LanesType)
def _number_to_lanes(context, builder, fromty, toty, value):
    return _spread(builder, context.cast(builder, value, fromty, types.float64))


@lower_cast(types.Boolean, MaskType)
def _truth_to_mask(context, builder, fromty, toty, value):
    return _spread(builder, value)


def call_llvm(builder, name, value):
    """Return what a function of LLVM makes of a number or of lanes."""
    ending = f"v{LANES}f64" if isinstance(value.type, ir.VectorType) else "f64"
    kind = ir.FunctionType(value.type, [value.type])
    return builder.call(cgutils.get_or_insert_function(builder.module, kind, f"{name}.{ending}"), [value])


def _operator(function, of, given, instruction):
    """Teach numba that ``function`` of one or two ``of`` gives ``given``, by an instruction of the builder."""

    class Typing(AbstractTemplate):
        def generic(self, args, kws):
            plain = types.Boolean if of is mask else types.Float | types.Integer
            if of in args and all(arg == of or isinstance(arg, plain) for arg in args):
                return signature(given, *[of] * len(args))
            return None

    infer_global(function)(Typing)
    for count in (1, 2):
        lower_builtin(function, *[of] * count)(lambda context, builder, sig, args: instruction(builder, *args))


_ARITHMETIC = {"fadd": (operator.add, operator.iadd), "fsub": (operator.sub, operator.isub),
               "fmul": (operator.mul, operator.imul), "fdiv": (operator.truediv,), "fneg": (operator.neg,)}  # fmt: skip
for _name, _functions in _ARITHMETIC.items():
    for _function in _functions:
        _operator(_function, lanes, lanes, getattr(ir.IRBuilder, _name))
for _function, _sign in ((operator.lt, "<"), (operator.le, "<="), (operator.gt, ">"), (operator.ge, ">="),
                         (operator.eq, "==")):  # fmt: skip
    _operator(_function, lanes, mask, lambda builder, a, b, sign=_sign: builder.fcmp_ordered(sign, a, b))
_operator(operator.ne, lanes, mask, lambda builder, a, b: builder.fcmp_unordered("!=", a, b))
for _function, _name in ((operator.and_, "and_"), (operator.or_, "or_"), (operator.xor, "xor")):
    _operator(_function, mask, mask, getattr(ir.IRBuilder, _name))
_operator(abs, lanes, lanes, lambda builder, a: call_llvm(builder, "llvm.fabs", a))


@intrinsic
def in_lanes(typingctx, value):
    """Return an array with the rigs along its last axis as one of lanes; of a tuple, all that it holds."""
    found = _laned(value)

    def codegen(context, builder, sig, args):
        return _as_lanes(context, builder, sig.args[0], args[0])

    return found(value), codegen


def _laned(kind: Any) -> Any:
    """Return the type that ``in_lanes`` gives."""
    if isinstance(kind, types.Array) and kind.dtype == types.float64:
        return types.Array(lanes, kind.ndim - 1, "C", aligned=False)
    if isinstance(kind, NamedTuples):
        inside = tuple(_laned(one) for one in kind)
        uniform = len(set(inside)) == 1
        of = kind.instance_class
        return types.NamedUniTuple(inside[0], len(inside), of) if uniform else types.NamedTuple(inside, of)
    return kind


def _as_lanes(context, builder, kind, value):
    found = _laned(kind)
    if found == kind:
        return value
    if isinstance(kind, NamedTuples):
        inside = [_as_lanes(context, builder, one, builder.extract_value(value, row)) for row, one in enumerate(kind)]
        return context.make_tuple(builder, found, inside)
    given, made = make_array(kind)(context, builder, value), make_array(found)(context, builder)
    made.data = builder.bitcast(given.data, made.data.type)
    made.shape = cgutils.pack_array(
        builder, cgutils.unpack_tuple(builder, given.shape)[:-1], context.get_value_type(types.intp)
    )
    made.strides = cgutils.pack_array(
        builder, cgutils.unpack_tuple(builder, given.strides)[:-1], context.get_value_type(types.intp)
    )
    made.nitems = builder.udiv(given.nitems, ir.Constant(given.nitems.type, LANES))
    made.itemsize = ir.Constant(given.itemsize.type, LANES * 8)
    made.meminfo, made.parent = given.meminfo, given.parent
    return made._getvalue()
