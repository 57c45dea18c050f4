# SPDX-License-Identifier: Apache-2.0
"""Numbers from outside: floats, of which none is NaN."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ._refusal import refuse


def numbers(name: str, values: Any) -> np.ndarray:
    """The values as an array of floats. Refuses what is no number, masked, or NaN."""
    try:
        array = np.asarray(values)
    except (TypeError, ValueError) as error:
        raise refuse(name, f"is no array of numbers: {error}") from None
    if array.dtype.kind not in "fiu":
        raise refuse(name, f"holds {array.dtype}; must be real numbers")
    if np.ma.is_masked(values):
        raise refuse(name, "has masked values; every value must be a number")
    array = array.astype(np.float64, copy=False)
    bad = np.isnan(array)
    if bad.any():
        raise refuse(name + _place(bad), "is nan; must be a number")
    return array


def finite_numbers(name: str, values: Any) -> np.ndarray:
    """The same, refusing infinity too."""
    array = numbers(name, values)
    bad = ~np.isfinite(array)
    if bad.any():
        raise refuse(name + _place(bad), f"is {array[bad][0]}; must be finite")
    return array


def write_table(file: Path, name: str, columns: Mapping[str, Any]) -> None:
    """Writes columns as CSV, every digit kept: the numbers that are read are those given. A column
    may hold texts, such as the names of runs."""
    arrays = {str(key): _column(f"{name}[{key!r}]", columns[key]) for key in columns}
    if not arrays:
        raise refuse(name, "has no columns")
    lengths = {key: array.shape for key, array in arrays.items()}
    first, *others = lengths
    for key in lengths:
        if len(lengths[key]) != 1 or lengths[key] != lengths[first]:
            raise refuse(
                f"{name}[{key!r}]",
                f"has the shape {lengths[key]}; must be one number for each of the "
                f"{lengths[first][0] if lengths[first] else 0} samples of {first!r}",
            )
    with file.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(arrays)
        table.writerows(zip(*(array.tolist() for array in arrays.values())))


def read_table(file: Path) -> dict[str, np.ndarray]:
    """The columns of numbers of a CSV file that the program wrote."""
    with file.open(newline="", encoding="utf-8") as stream:
        rows = csv.reader(line for line in stream if not line.startswith("#"))
        names = next(rows)
        values = np.array([[float(cell) for cell in row] for row in rows])
    return {name: values[:, i] for i, name in enumerate(names)}


def _column(name: str, values: Any) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind == "O" and all(isinstance(one, str) for one in array.flat):
        array = array.astype(str)
    return array if array.dtype.kind == "U" else finite_numbers(name, values)


def _place(bad: np.ndarray) -> str:
    """Where the first one stands: "[3]", "[0, 2]"; nothing for a single number."""
    if bad.ndim == 0:
        return ""
    return f"[{', '.join(str(i) for i in np.argwhere(bad)[0])}]"
