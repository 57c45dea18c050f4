# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, Union

from ._actuator import Actuator, Source, add_conditions
from ._question import Progress, Question, path_word
from ._refusal import refuse
from ._results import Result

#: A table as its file, or as columns: a mapping of names to arrays, or a data frame.
Table = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def lint(*actuators: Source | Actuator) -> Result:
    """Contradictions between the stated numbers of actuators; several are compared too.

    ``actuators``: files, dictionaries or ``Actuator``.

    Returns the document of kind ``lint_report``: what ``actuator lint --json`` prints; values in
    it have their units beside them.

    Raises ``Refusal`` with every fault of a document.

    >>> torquewright.lint("specs/actuator/d151_knee.json")["findings"][0]["severity"]
    'note'
    """
    if not actuators:
        raise refuse("actuators", "is missing; must be one or more")
    with Question("actuator", "lint") as question:
        for i, one in enumerate(actuators):
            question.argument(question.document(f"actuator_{i + 1}", _source(one)))
        return question.answer()


def check(
    motion: Table,
    joints: Mapping[str, Source | Actuator],
    *,
    columns: Iterable[str] = (),
    from_s: float | None = None,
    until_s: float | None = None,
    torque_includes_inertia: bool | None = None,
    repeat: int | None = None,
    pause_s: float | None = None,
    bus_voltage_V: float | None = None,
    state_of_charge: float | None = None,
    winding_temperature_K: float | None = None,
    rating: str = "peak",
) -> Result:
    """Can the actuators do this motion?

    ``motion``: a CSV file, or columns of arrays: ``time_s`` and, for each joint,
    ``<joint>_position_rad``, ``<joint>_velocity_rad_s``, ``<joint>_torque_Nm``. Other names:
    ``columns``, such as ``"t=time:ms"`` or ``"v=knee.velocity:rpm"``. ``joints``: the actuator of
    each joint. ``from_s``, ``until_s``: the part of the motion that counts.
    ``torque_includes_inertia``: whether the torques hold those of rotor and gears; None: both
    readings count. ``repeat``, ``pause_s``: runs of the motion and the pause after each, for the
    winding's temperature. Conditions as for ``Actuator.region``.

    Returns the document of kind ``check_report``: what ``actuator check --json`` prints;
    ``verdict`` is ``"pass"``, ``"fail"`` or ``"undecided"``.

    Raises ``Refusal`` for documents and motions that cannot be read, NaN, and conditions out of
    range.

    >>> torquewright.check("specs/trajectory/knee_extension.csv",
    ...                    {"knee": "specs/actuator/d151_knee.json"})["verdict"]
    'pass'
    """
    with Question("actuator", "check") as question:
        for name, one in _items("joints", joints):
            file = question.document(f"actuator_{name}", _source(one))
            question.option("joints", "--joint", f"{name}={file}")
        _add_reading(question, columns, from_s, until_s)
        question.flag("torque_includes_inertia", "--torque-includes-inertia",
                      torque_includes_inertia is True)
        question.flag("torque_includes_inertia", "--torque-excludes-inertia",
                      torque_includes_inertia is False)
        question.count("repeat", "--repeat", repeat)
        question.number("pause_s", "--pause", pause_s)
        add_conditions(question, rating, bus_voltage_V, state_of_charge, winding_temperature_K)
        question.argument(question.table("motion", motion))
        return question.answer()


def hopper_check(
    robot: Source,
    motion: Table,
    *,
    columns: Iterable[str] = (),
    from_s: float | None = None,
    until_s: float | None = None,
    candidates: str | os.PathLike[str] | None = None,
    repeat: int | None = None,
    pause_s: float | None = None,
    bus_voltage_V: float | None = None,
    state_of_charge: float | None = None,
    winding_temperature_K: float | None = None,
    rating: str = "peak",
    progress: Progress = None,
) -> Result:
    """Can the whole robot do this motion? Dynamics, mechanisms, regions, heat, gear loads.

    ``robot``: a document of kind ``robot``. ``motion``: a CSV file or columns of arrays, as for
    ``check``, with the base (``base_x_position_m``, ``base_z_position_m``,
    ``base_pitch_position_rad``). ``candidates``: a folder of actuators and gearboxes to try in
    every place. The others as for ``check``, conditions as for ``Actuator.region``.
    ``progress``: a function that hears how far long work is, in a terminal's words.

    Returns the document of kind ``check_report``: what ``hopper check --json`` prints.

    Raises ``Refusal`` for documents and motions that cannot be read, NaN, and conditions out of
    range.

    >>> torquewright.hopper_check("specs/robot/hopper.json",
    ...                           "specs/trajectory/hopper_squat.csv")["verdict"]
    'pass'
    """
    with Question("hopper", "check") as question:
        question.progress(progress)
        _add_reading(question, columns, from_s, until_s)
        question.text("candidates", "--candidates", candidates)
        question.count("repeat", "--repeat", repeat)
        question.number("pause_s", "--pause", pause_s)
        add_conditions(question, rating, bus_voltage_V, state_of_charge, winding_temperature_K)
        question.argument(question.document("robot", robot))
        question.argument(question.table("motion", motion))
        return question.answer()


def identify(
    logs: Table | list[Table],
    rig: Source,
    actuator: Source | Actuator | Mapping[str, Source | Actuator],
    *,
    only: Iterable[str] = (),
    without: Iterable[str] = (),
    tolerance: float | None = None,
    empirical: bool = False,
    refined: str | os.PathLike[str] | None = None,
    progress: Progress = None,
) -> Result:
    """Is the model true, and if not, which effect is missing?

    ``logs``: a CSV file or columns of arrays, or a list of them, from one rig. ``rig``: the
    document of kind ``rig`` that says what the columns are, with their units. ``actuator``: as
    designed; on a serial arm a dictionary with the actuator of each joint. ``only``, ``without``:
    effects that may, or may not, be named. ``tolerance``: what changes the prediction by a smaller
    share is not named; 0 to 1. ``empirical``: where no effect fits, a table. ``refined``: a file
    to be written, the actuator with what was found (not for a serial arm).
    ``progress``: a function that hears how far long work is, in a terminal's words.

    Returns the document of kind ``identification_report``: what ``identify --json`` prints.

    Raises ``Refusal`` for documents and logs that cannot be read, NaN, and effects that are not
    known.

    >>> torquewright.identify("specs/log/bench_as_built.csv", "specs/log/bench_rig.json",
    ...                       "specs/log/bench_actuator.json")["verdict"]
    'explained'
    """
    with Question("identify") as question:
        question.progress(progress)
        tables = logs if isinstance(logs, (list, tuple)) else [logs]
        for i, log in enumerate(tables):
            question.argument(question.table("log" if len(tables) == 1 else f"log_{i + 1}", log))
        question.option("rig", "--rig", question.document("rig", rig))
        if isinstance(actuator, Mapping) and "kind" not in actuator:
            for name, one in _items("actuator", actuator):
                file = question.document(f"actuator_{name}", _source(one))
                question.option("actuator", "--actuator", f"{name}={file}")
        else:
            file = question.document("actuator", _source(actuator))
            question.option("actuator", "--actuator", file)
        question.texts("only", "--only", only)
        question.texts("without", "--without", without)
        question.number("tolerance", "--tolerance", tolerance)
        question.flag("empirical", "--empirical", empirical)
        if refined is not None:
            refined = path_word("refined", refined)
        question.text("refined", "--refined", refined)
        return question.answer()


def optimize(
    problem: Source,
    *,
    top: int | None = None,
    time_limit_s: float | None = None,
    max_nodes: int | None = None,
    verify: bool = False,
    progress: Progress = None,
) -> Result:
    """The best gearbox of a problem, proved.

    ``problem``: a document of kind ``gearbox_problem`` (``module_mm``, ``target_ratio``, ...).
    ``top``: how many of the best designs. ``time_limit_s``, ``max_nodes``: where the search ends
    with what it has. ``verify``: check the proof with the independent checker.
    ``progress``: a function that hears how far long work is, in a terminal's words.

    Returns the document of kind ``gearbox_result``: what ``gearbox optimize --json`` prints;
    ``status`` is ``"optimal"``, ``"infeasible"`` or ``"limit"``.

    Raises ``Refusal`` with every fault of the document, and for numbers out of range.

    >>> torquewright.optimize("specs/gearbox/d151_knee.json")["designs"][0]["teeth"]["sun"]
    44
    """
    with Question("gearbox", "optimize") as question:
        question.progress(progress)
        question.count("top", "--top", top)
        question.number("time_limit_s", "--time-limit", time_limit_s)
        question.count("max_nodes", "--max-nodes", max_nodes)
        question.flag("verify", "--verify", verify)
        question.argument(question.document("problem", problem))
        return question.answer()


def _source(one: Source | Actuator) -> Source:
    return one.source if isinstance(one, Actuator) else one


def _items(keyword: str, mapping: Any) -> list[tuple[str, Any]]:
    if not isinstance(mapping, Mapping) or "kind" in mapping:
        raise refuse(keyword, "must be a dictionary with the actuator of each joint by its name")
    for name in map(str, mapping):
        if not name or "=" in name:
            raise refuse(keyword, f"has the name {name!r}; must be one letter or more, without \"=\"")
    return [(str(name), one) for name, one in mapping.items()]


def _add_reading(
    question: Question, columns: Iterable[str], from_s: float | None, until_s: float | None
) -> None:
    question.texts("columns", "--column", columns)
    question.number("from_s", "--from", from_s)
    question.number("until_s", "--until", until_s)
