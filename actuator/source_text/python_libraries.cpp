// SPDX-License-Identifier: Apache-2.0
// What the exported module asks of an array library, and how each answers: the array API standard
// (data-apis.org/array-api, 2024.12: asarray, astype, take, where, clip, minimum, maximum, abs,
// sqrt, tanh, sum, reshape, result_type), NumPy 1.24, PyTorch 1.13.
#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kText = R"(

class _Standard:
    """What differs between array libraries; this one knows the array API standard alone."""

    def __init__(self, xp, dtype, device):
        self.xp = xp
        self.dtype = dtype
        self.piece = 16384 if xp.__name__ == "numpy" else 0
        self.place = {} if device is None else {"device": device}

    def floats(self, values):
        return self.xp.asarray(values, dtype=self.dtype, **self.place)

    def whole(self, values):
        return self.xp.asarray(values, dtype=self.xp.int32, **self.place)

    def is_traced(self):
        """Whether a compiler follows that makes one kernel of operations on arrays of one shape."""
        return False

    def lies_outside(self, value, low, high):
        """Whether any of the values does, where that can be seen without waiting for a device."""
        if hasattr(value, "shape"):
            return False
        return value < low or value > high

    def cast(self, array, dtype):
        return self.xp.astype(array, dtype)

    def take(self, table, rows):
        flat = self.xp.take(table, self.xp.reshape(rows, (-1,)), axis=0)
        return self.xp.reshape(flat, tuple(rows.shape) + tuple(table.shape[1:]))

    def passed(self, breaks, cell, place):
        """How many of a cell's points a place has passed."""
        if len(breaks.shape) == 1:
            return self.count(place >= self.take(breaks, cell))
        if self.is_traced():
            return sum(self.count(place >= breaks[:, k][cell]) for k in range(breaks.shape[1]))
        return self.xp.sum(self.count(place[..., None] >= self.take(breaks, cell)), axis=-1)

    def cell(self, place, last):
        """Which cell a place lies in; that of what is no number is some cell."""
        whole = self.xp.astype(self.xp.where(place == place, place, self.xp.zeros_like(place)), self.xp.int32)
        return self.clip(whole, 0, last)

    def past(self, place, whole):
        return place - self.xp.astype(whole, self.dtype)

    def count(self, claims):
        return self.xp.astype(claims, self.xp.int32)

    def clip(self, array, low, high):
        return self.xp.clip(array, low, high)

    def between(self, array, least, greatest, out=None):
        if out is not None:
            raise TypeError(self.xp.__name__ + " writes into no array: call without out")
        return self.xp.minimum(self.xp.maximum(array, least), greatest)

    def at_least(self, array, low):
        return self.xp.clip(array, low, None)

    def line(self, value, slope, x):
        return value + x * slope

    def mixed(self, one, other, share):
        return one + share * (other - one)


class _NumPy(_Standard):
    """NumPy and CuPy."""

    def floats(self, values):
        return self.xp.asarray(values, dtype=self.dtype)

    def whole(self, values):
        return self.xp.asarray(values, dtype=self.xp.int32)

    def lies_outside(self, value, low, high):
        if self.xp.__name__ == "numpy" and hasattr(value, "shape"):
            return bool(((value < low) | (value > high)).any())
        return _Standard.lies_outside(self, value, low, high)

    def cast(self, array, dtype):
        return array.astype(dtype)

    def take(self, table, rows):
        return self.xp.take(table, rows, axis=0)

    def cell(self, place, last):
        return self.xp.fmax(self.xp.fmin(place, last), 0).astype(self.xp.intp)

    def past(self, place, whole):
        return self.cast(place - whole, self.dtype)

    def count(self, claims):
        return claims

    def clip(self, array, low, high):
        return self.xp.minimum(self.xp.maximum(array, low), high)

    def at_least(self, array, low):
        return self.xp.maximum(array, low)

    def between(self, array, least, greatest, out=None):
        raised = self.xp.maximum(array, least, out=out)
        return self.xp.minimum(raised, greatest, out=out)


class _Jax(_NumPy):
    """Constants are NumPy's, which no trace keeps."""

    def floats(self, values):
        return sys.modules["numpy"].asarray(values, dtype=self.dtype)

    def whole(self, values):
        return sys.modules["numpy"].asarray(values, dtype="int32")

    def cell(self, place, last):
        return self.xp.clip(place.astype(self.xp.int32), 0, last)

    between = _Standard.between
    lies_outside = _Standard.lies_outside


class _Torch(_Standard):
    def __init__(self, xp, dtype, device):
        _Standard.__init__(self, xp, dtype, device)
        self.has_compiler = hasattr(getattr(xp, "compiler", None), "is_compiling")

    def is_traced(self):
        return self.has_compiler and self.xp.compiler.is_compiling()

    def floats(self, values):
        with self.xp.inference_mode(False):
            return self.xp.tensor(values, dtype=self.dtype, **self.place)

    def whole(self, values):
        with self.xp.inference_mode(False):
            return self.xp.tensor(values, dtype=self.xp.int64, **self.place)

    def lies_outside(self, value, low, high):
        if hasattr(value, "shape") and value.device.type == "cpu":
            return bool(((value < low) | (value > high)).any())
        return _Standard.lies_outside(self, value, low, high)

    def cast(self, array, dtype):
        return array.to(dtype)

    def take(self, table, rows):
        return table[rows]

    def cell(self, place, last):
        return place.long().clamp(0, last)

    def past(self, place, whole):
        return place - whole

    def count(self, claims):
        return claims.int() if self.is_traced() else claims

    def clip(self, array, low, high):
        return array.clamp(low, high)

    def at_least(self, array, low):
        return array.clamp(min=low)

    def between(self, array, least, greatest, out=None):
        return self.xp.clamp(array, least, greatest, out=out)

    def line(self, value, slope, x):
        return self.xp.addcmul(value, x, slope)

    def mixed(self, one, other, share):
        return self.xp.lerp(one, other, share)


def _tools_of(xp, dtype, device):
    kinds = {"numpy": _NumPy, "cupy": _NumPy, "jax": _Jax, "torch": _Torch}
    return kinds.get(xp.__name__.partition(".")[0], _Standard)(xp, dtype, device)
)";

}  // namespace

std::string_view python_libraries() { return kText; }

}  // namespace torquewright::actuator
