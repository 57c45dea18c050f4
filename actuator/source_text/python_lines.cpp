// SPDX-License-Identifier: Apache-2.0
// Lines between points as tables in which a row is found by arithmetic: no search, so that a
// compiler fuses it and ONNX holds it.
#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kText = R"(
import collections
import sys
import warnings


def _namespace(array):
    """The array's own library. It is loaded, since its array is here: nothing is imported."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    library = type(array).__module__.partition(".")[0]
    if library == "builtins":
        raise TypeError("velocity must be an array, as of NumPy, PyTorch or JAX")
    return sys.modules["jax.numpy" if library in ("jax", "jaxlib") else library]


def _single(x):
    """The nearest number of single precision."""
    most = (2.0**29 + 1.0) * x  # Veltkamp's splitting: the leading 24 bits
    return most - (most - x)


def _single_from(x):
    """The least number of single precision that is not below x."""
    y = _single(x)
    return y if y >= x else _single(y + max(0.5000001 * 2.0**-23 * abs(y), 1.5e-45))


class _Lines:
    """Lines between points, found without a search.

    Cells of one width lie over the points; a cell knows the few points in it, and of each stretch
    that it touches the line: where it is anchored, its values there and its slopes. Anchors are
    numbers of the precision that is computed in, so that no steepness magnifies a rounding.
    """

    MOST_CELLS = 4096
    BESIDE = 1e-3  # of a cell: points so near count as in it, whichever way a place is rounded

    def __init__(self, points, columns, is_single, goes_on=False):
        anchor = _single if is_single else float
        self.low, self.high = anchor(points[0]), anchor(points[-1])
        first, last = 0, len(points) - 1
        knots, lines = [], []
        for i in range(last):
            width = points[i + 1] - points[i]
            if width <= 0.0:
                continue
            slopes = [(column[i + 1] - column[i]) / width for column in columns]
            at = anchor(points[i])
            values = [c[i] + s * (at - points[i]) for c, s in zip(columns, slopes)]
            knots.append(points[i])
            lines.append([at, *values, *slopes])
        flat = [0.0] * len(columns)
        if goes_on:
            del knots[0]
        else:  # beyond the ends their values hold
            lines.insert(0, [anchor(points[first]), *(c[first] for c in columns), *flat])
            knots.append(points[last])
            lines.append([anchor(points[last]), *(c[last] for c in columns), *flat])
        if is_single:  # of points between which no number of that precision lies the last counts
            knots, lines = _as_singles(knots, lines)
        self.knots, self.lines = knots, lines
        self.near = 2.0**-24 * max(abs(self.low), abs(self.high)) if is_single else 0.0
        self.beyond = 1e-6 * (self.high - self.low)  # past the ends, where their values hold
        self._choose_cells()

    def _choose_cells(self):
        """The fewest points to compare with in a cell, then the fewest cells: of one width in
        speed, or, where a bound ends upright, of one width in the fourth root of the distance to
        the nearer end, which lays them along the bound."""
        best = None
        for is_laid_along in (False, True):
            cells = 8
            while cells <= self.MOST_CELLS:
                found = self._cells(cells, is_laid_along)
                most = max(1, max(len(inside) for _, inside in found))
                if best is None or most < best[0]:
                    best = most, cells, is_laid_along, found
                if most == 1:
                    break
                cells *= 2
            if best[0] == 1:
                break
        self.most, self.cells, self.is_laid_along, found = best
        self._use(found)

    def use(self, cells, most):
        """With so many cells of one width, and so many points in each."""
        self.cells, self.is_laid_along = cells, False
        found = self._cells(cells, False)
        self.most = max(most, max(len(inside) for _, inside in found))
        self._use(found)

    def _use(self, found):
        self.sides = self.most + 1
        half = 0.5 * (self.high - self.low)
        self.per_width = self.cells / (2.0 * half)
        if self.is_laid_along:
            self.per_width = 0.5 * self.cells / half**0.25
        self.breaks = [
            inside + [3.0e38] * (self.most - len(inside)) for _, inside in found
        ]
        last = len(self.lines) - 1
        self.numbers = [
            min(before + side, last) for before, _ in found for side in range(self.sides)
        ]

    def _edges(self, cells, is_laid_along):
        """Where the cells meet, each with what rounding may make of a place."""
        width = (self.high - self.low) / cells
        if not is_laid_along:
            beside = self.BESIDE * width + self.near
            return [(self.low + i * width - beside, self.low + i * width + beside) for i in range(cells + 1)]
        half = 0.5 * (self.high - self.low)
        root = half**0.25 / (cells // 2)
        edges = []
        for i in range(cells // 2 + 1):
            near, far = ((max(0.0, i + of) * root) ** 4 for of in (-self.BESIDE, self.BESIDE))
            edges.append((near, far))
        first = [(self.low + near, self.low + far) for near, far in edges]
        second = [(self.high - far, self.high - near) for near, far in reversed(edges[:-1])]
        return first + second

    def _cells(self, cells, is_laid_along):
        """Of each: how many points lie before it, and those in it."""
        edges = self._edges(cells, is_laid_along)
        most = sys.float_info.max
        edges[0], edges[-1] = (-most, edges[0][1]), (edges[-1][0], most)
        found, before, end = [], 0, 0
        for (low, _), (_, high) in zip(edges, edges[1:]):
            while before < len(self.knots) and self.knots[before] < low:
                before += 1
            end = max(end, before)
            while end < len(self.knots) and self.knots[end] <= high:
                end += 1
            found.append((before, self.knots[before:end]))
        return found


def _as_singles(knots, lines):
    kept, kept_lines = [], [lines[0]]
    for knot, line in zip(map(_single_from, knots), lines[1:]):
        if kept and knot == kept[-1]:
            kept_lines[-1] = line
        else:
            kept.append(knot)
            kept_lines.append(line)
    return kept, kept_lines
)";

}  // namespace

std::string_view python_lines() { return kText; }

}  // namespace torquewright::actuator
