# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import json
import os
from typing import Any

from . import _core
from ._question import Question, path_word


def read(path: str | os.PathLike[str]) -> dict[str, Any]:
    """The document of any kind in the file ``path``, as a dictionary.

    It is as its schema demands: kind and version, required keys, types, ranges (the unit is in
    each key's name: ``bus_voltage_V``, ``ratio``), no unknown keys. What its numbers mean together
    is checked by whoever computes with them.

    Raises ``Refusal`` with every fault of the document: file, place, value, what is allowed.

    >>> torquewright.read("specs/actuator/d151_knee.json")["drive"]["bus_voltage_V"]
    67.2
    """
    return json.loads(_core.read(os.fsencode(path_word("path", path))))


def schema(kind: str) -> dict[str, Any]:
    """The JSON Schema of a kind of documents: every key with its meaning, unit and allowed values.

    ``kind`` is a word such as ``"actuator"``, ``"gearbox_problem"``, ``"rig"``, ``"robot"``.

    Raises ``Refusal``, which lists the kinds, for any other word.

    >>> sorted(torquewright.schema("gearbox")["required"])
    ['kind', 'module_mm', 'planet_count', 'teeth', 'topology', 'version']
    """
    with Question("schema") as question:
        question.argument("--")
        question.argument(str(kind))
        return json.loads(question.printed())
