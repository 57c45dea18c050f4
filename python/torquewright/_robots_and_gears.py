# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from ._actuator import Source
from ._arrays import read_table
from ._question import Progress, Question, finite_number
from ._refusal import refuse
from ._reports import Table, optimize
from ._results import Result


class Gearbox:
    """A problem of gears, of kind ``gearbox_problem``. Made by ``gearbox()``."""

    def __init__(self, problem: Source) -> None:
        self.problem = problem

    def optimize(self, **options: Any) -> Result:
        """The best gearbox, proved: ``torquewright.optimize`` with its options."""
        return optimize(self.problem, **options)


def gearbox(problem: Source) -> Gearbox:
    """A problem of gears, to be asked for its best design: ``.optimize()``, with the options of
    ``torquewright.optimize``.

    ``problem``: a document of kind ``gearbox_problem`` (``module_mm``, ``target_ratio``, ...).

    Raises ``Refusal``, as ``optimize`` does, when it is asked.

    >>> torquewright.gearbox("specs/gearbox/d151_knee.json").optimize().status
    'optimal'
    """
    return Gearbox(problem)


def strength(
    gears: Source,
    *,
    torque_Nm: Iterable[float] = (),
    side: str | None = None,
    cycles: float | None = None,
) -> Result:
    """What torques do to the teeth.

    ``gears``: of kind ``gear_strength`` or ``gearbox_result``. ``torque_Nm``: those to be tried,
    at ``side`` ``"motor"`` or ``"joint"``. ``cycles``: how often the most loaded tooth is loaded.

    Returns the document of kind ``strength_report``: what ``gearbox strength --json`` prints.

    Raises ``Refusal`` for documents that cannot be read and numbers out of range.

    >>> torquewright.strength("specs/gearbox/d151_strength.json", torque_Nm=[21.0]).kind
    'strength_report'
    """
    with Question("gearbox", "strength") as question:
        torques = [repr(finite_number("torque_Nm", one)) for one in torque_Nm]
        if torques:
            question.option("torque_Nm", "--torque", ",".join(torques))
        question.text("side", "--side", side)
        question.number("cycles", "--cycles", cycles)
        question.argument(question.document("gears", gears))
        return question.answer()


def flip(
    robot: Source, *, motion: str | os.PathLike[str] | None = None, task: str | None = None,
    limits: str | None = None, progress: Progress = None,
) -> Result:
    """A flip, a jump or a hop that the robot's actuators can do, planned.

    ``robot``: the document of kind ``robot``. ``motion``: a file for the motion, CSV; without one
    the report holds it under ``motion``, as columns of arrays that ``replay`` takes. ``task``:
    ``"flip"``, ``"jump"`` or ``"hop"``. ``limits``: ``"mor"``, the drives' regions, or ``"box"``.
    ``progress``: a function that hears how far long work is, in a terminal's words.

    Returns the report: what ``hopper flip --json`` prints, torques in it in Nm (``_Nm``). Ctrl-C
    ends the search.

    Raises ``Refusal`` for a document that cannot be read.

    >>> torquewright.flip("specs/robot/hopper.json", task="dance")
    Traceback (most recent call last):
    torquewright.Refusal: task: ...
    """
    with Question("hopper", "flip") as question:
        question.progress(progress)
        question.text("task", "--task", task)
        question.text("limits", "--limits", limits)
        file = None
        if motion is None:
            file = question.written_table("motion", "--output")
        question.text("motion", "--output", motion)
        question.argument(question.document("robot", robot))
        report = question.answer()
        if file is not None and file.exists():
            report["motion"] = read_table(file)
        return report


def replay(
    robot: Source,
    motion: Table,
    *,
    controller: str | None = None,
    engine: str | None = None,
    limits: str | None = None,
    trials: int | None = None,
    seed: int | None = None,
    progress: Progress = None,
) -> Result:
    """Whether the robot does the motion, simulated and controlled.

    ``robot``: the document of kind ``robot``. ``motion``: a CSV file, or columns of arrays, as for ``hopper_check``, or the file of a policy.
    ``controller``, ``engine``, ``limits``: the words of ``hopper replay --help``. ``trials``,
    ``seed``: of robots that are not quite what their document says.
    ``progress``: a function that hears how far long work is, in a terminal's words.

    Returns the document of kind ``replay_report``: what ``hopper replay --json`` prints, torques
    in it in Nm (``_Nm``).

    Raises ``Refusal`` for documents and motions that cannot be read.

    >>> torquewright.replay("specs/robot/hopper.json", "specs/trajectory/hopper_squat.csv", trials=1.5)
    Traceback (most recent call last):
    torquewright.Refusal: trials: is 1.5; must be a whole number
    """
    if isinstance(motion, dict) and motion.get("kind") == "policy":
        raise refuse("motion", "is the dictionary of a policy; must be its file")
    with Question("hopper", "replay") as question:
        question.progress(progress)
        question.text("controller", "--controller", controller)
        question.text("engine", "--engine", engine)
        question.text("limits", "--limits", limits)
        question.count("trials", "--trials", trials)
        question.count("seed", "--seed", seed)
        question.argument(question.document("robot", robot))
        question.argument(question.table("motion", motion))
        return question.answer()
