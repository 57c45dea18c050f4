# SPDX-License-Identifier: Apache-2.0
"""An array library that knows no more than the array API standard (2024.12): what the exported
module may use of a library that it has not heard of. Its arrays hold NumPy's; what NumPy does beyond
the standard (methods, mixed kinds, gathers by arrays of several axes) they refuse."""

import sys
import types

import numpy

OPERATORS = ("add", "radd", "sub", "rsub", "mul", "rmul", "truediv", "rtruediv", "neg",
             "lt", "le", "gt", "ge", "eq", "ne")


class Array:
    def __init__(self, values):
        self._values = numpy.asarray(values)

    def __array_namespace__(self):
        return library

    dtype = property(lambda self: self._values.dtype)
    ndim = property(lambda self: self._values.ndim)
    shape = property(lambda self: self._values.shape)
    device = property(lambda self: "cpu")

    def __getitem__(self, place):
        for one in place if isinstance(place, tuple) else (place,):
            if not (one is None or one is Ellipsis or isinstance(one, (int, slice))):
                raise TypeError("gathers are take()")
        return Array(self._values[place])


def plain(value):
    if isinstance(value, numpy.ndarray):
        raise TypeError("an array of another library")
    return value._values if isinstance(value, Array) else value


def operator(name):
    function = getattr(numpy.ndarray, f"__{name}__")

    def apply(self, *others):
        for other in others:
            if isinstance(other, Array) and self.dtype.kind != other.dtype.kind:
                raise TypeError("kinds are mixed: " + str([self.dtype, other.dtype]))
        return Array(function(self._values, *map(plain, others)))

    return apply


for name in OPERATORS:
    setattr(Array, f"__{name}__", operator(name))


def take(array, rows, *, axis):
    assert rows.ndim == 1 and rows.dtype.kind == "i"
    return Array(numpy.take(plain(array), plain(rows), axis=axis))


def clip(array, low=None, high=None):
    return Array(numpy.clip(plain(array), low, high))


def between_arrays(function):
    def apply(one, other):
        assert isinstance(one, Array) and isinstance(other, Array)
        return Array(function(plain(one), plain(other)))

    return apply


library = types.ModuleType("standard_arrays")
library.int32, library.float32, library.float64 = numpy.int32, numpy.float32, numpy.float64
library.asarray = lambda values, dtype=None, device=None: Array(numpy.asarray(plain(values), dtype))
library.astype = lambda array, dtype: Array(plain(array).astype(dtype))
library.result_type = numpy.result_type
library.take, library.clip = take, clip
library.minimum, library.maximum = between_arrays(numpy.minimum), between_arrays(numpy.maximum)
library.sum = lambda array, *, axis: Array(numpy.sum(plain(array), axis=axis))
library.reshape = lambda array, shape: Array(numpy.reshape(plain(array), shape))
library.where = lambda claims, one, other: Array(numpy.where(*map(plain, (claims, one, other))))
for name in ("abs", "sqrt", "tanh", "zeros_like"):
    setattr(library, name, lambda array, of=getattr(numpy, name): Array(of(plain(array))))
sys.modules["standard_arrays"] = library
