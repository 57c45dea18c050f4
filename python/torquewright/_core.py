# SPDX-License-Identifier: Apache-2.0
"""The compiled part of the package, _library.so, as Python calls it: what the package's other files
are written with, not for others. By ctypes, so that one library serves every version of Python;
other threads go on while one of its functions runs."""

from __future__ import annotations

import ctypes
import os
import weakref
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ._refusal import Refusal, refuse

# How calls end beside the program's own exit codes, as python/entries.cpp has them.
_REFUSED, _FAILED, _INTERRUPTED = -1, -2, -3

_Tell = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p)

_library = ctypes.CDLL(os.path.join(os.path.dirname(os.path.abspath(__file__)), "_library.so"))
_size, _place = ctypes.c_size_t, ctypes.c_void_p
for _name, _answer, _takes in (
    ("run", ctypes.c_int, [ctypes.POINTER(ctypes.c_char_p), _size, _Tell]),
    ("read", ctypes.c_int, [ctypes.c_char_p]),
    ("text_count", _size, []),
    ("text", _place, [_size, ctypes.POINTER(_size)]),
    ("version", ctypes.c_char_p, []),
    ("new_table", _place, [_place, _place, _place, _size, ctypes.c_double]),
    ("free_table", None, [_place]),
    ("clip", None, [_place, _place, _place, _place, _size]),
):
    _function = getattr(_library, "torquewright_" + _name)
    _function.restype, _function.argtypes = _answer, _takes

version: str = _library.torquewright_version().decode()


def run(words: Sequence[bytes], progress: Callable[[str], object] | None = None) -> tuple[int, str]:
    """Runs a command of the program: its exit code and what it printed. What ``progress`` raises
    ends the work and is raised."""
    for word in words:
        _require_no_end(word)
    raised: list[BaseException] = []

    def tell(text: bytes) -> int:
        if not raised:
            try:
                progress(_decoded(text))  # type: ignore[misc]
            except BaseException as error:  # whatever it is, it must not pass through C
                raised.append(error)
        return len(raised)

    given = (ctypes.c_char_p * len(words))(*words)
    heard = _Tell() if progress is None else _Tell(tell)
    code = _library.torquewright_run(given, len(words), heard)
    if raised:
        raise raised[0]
    return code, _said(code)


def read(file: bytes) -> str:
    """A document of any kind, checked, as JSON."""
    _require_no_end(file)
    return _said(_library.torquewright_read(file))


class RegionClip:
    """The region's table, ready to clip arrays. ``error_Nm`` is by how much lines between its rows
    may be off: both bounds are drawn in by it. Speeds ascend; ValueError where they do not."""

    def __init__(self, speed_rad_s: Any, least_Nm: Any, greatest_Nm: Any, error_Nm: float) -> None:
        rows = [_floats(of) for of in (speed_rad_s, least_Nm, greatest_Nm)]
        if {row.shape for row in rows} != {(rows[0].size,)}:
            raise ValueError("speeds and bounds must be of one length")
        places = (row.ctypes.data for row in rows)
        self._table = _library.torquewright_new_table(*places, rows[0].size, error_Nm)
        if not self._table:
            raise ValueError(_texts()[0])
        weakref.finalize(self, _library.torquewright_free_table, self._table)

    def clip(self, torque_Nm: np.ndarray, speed_rad_s: np.ndarray) -> np.ndarray:
        """Arrays of one shape, which is that of the answer."""
        torques, speeds = _floats(torque_Nm), _floats(speed_rad_s)
        if torques.shape != speeds.shape:
            raise ValueError("torques and speeds must be of one shape")
        clipped = np.empty(torques.shape)
        places = (array.ctypes.data for array in (speeds, torques, clipped))
        _library.torquewright_clip(self._table, *places, clipped.size)
        return clipped


def _floats(values: Any) -> np.ndarray:
    """Side by side, as C takes them; of any shape, that of a number too."""
    return np.asarray(values, dtype=np.float64, order="C")


def _require_no_end(word: bytes) -> None:
    """C takes words that end where the first such character stands."""
    if b"\0" in word:
        place = _decoded(word.partition(b"\0")[0])
        raise refuse(place, "holds the character U+0000; must be a text")


def _said(code: int) -> str:
    """What this thread's last call printed; or raises what it ended with."""
    if code == _INTERRUPTED:
        raise KeyboardInterrupt
    texts = _texts()
    if code == _REFUSED:
        raise Refusal(list(zip(texts[0::3], texts[1::3], texts[2::3])))
    if code == _FAILED:
        raise RuntimeError(texts[0])
    return texts[0]


def _texts() -> list[str]:
    length = _size()
    texts = []
    for i in range(_library.torquewright_text_count()):
        begin = _library.torquewright_text(i, ctypes.byref(length))
        texts.append(_decoded(ctypes.string_at(begin, length.value)))
    return texts


def _decoded(text: bytes) -> str:
    """A sentence may quote bytes of a file that are no UTF-8: they become U+FFFD."""
    return text.decode("utf-8", "replace")
