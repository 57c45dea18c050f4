# SPDX-License-Identifier: Apache-2.0
"""What is said of input that cannot be used."""

from typing import Iterable, NamedTuple


class Fault(NamedTuple):
    """One thing that is wrong: where, and a sentence with the value and what is allowed."""

    file: str  #: A file, or the name of an argument.
    path: str  #: JSON pointer to the value in it; empty: it is the whole of it.
    message: str


class Refusal(ValueError):
    """Input that cannot be used: every fault that was found, a line each, as the program says it.

    ``faults`` holds the same as tuples ``(file, path, message)``.
    """

    def __init__(self, faults: Iterable[tuple[str, str, str]]) -> None:
        self.faults = tuple(Fault(*fault) for fault in faults)
        super().__init__("\n".join(_line(fault) for fault in self.faults))

    def __reduce__(self) -> tuple:
        return type(self), (self.faults,)


def refuse(place: str, message: str) -> Refusal:
    """To be raised: one fault of an argument as a whole."""
    return Refusal([(place, "", message)])


def _line(fault: Fault) -> str:
    place = f"{fault.file}#{fault.path}" if fault.path else fault.file
    return "".join(
        f"\\u{ord(one):04x}" if one < " " or one == "\x7f" else one
        for one in f"{place}: {fault.message}"
    )
