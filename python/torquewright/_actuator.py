# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import copy
import os
import types
from collections.abc import Mapping
from typing import Any, Union

import numpy as np

from . import _core
from ._arrays import finite_numbers, numbers
from ._documents import read
from ._question import Question, finite_number
from ._refusal import refuse
from ._results import Result

#: A document as its file or as a dictionary.
Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]

#: The columns of a region, in the order of documents of kind mor_table.
_NUMBERS = (
    "speed_rad_s",
    "torque_min_Nm",
    "torque_max_Nm",
    "current_min_A",
    "current_max_A",
    "bus_power_at_min_W",
    "bus_power_at_max_W",
)
_WORDS = ("limiter_min", "limiter_max")


def add_conditions(
    question: Question,
    rating: str | None,
    bus_voltage_V: float | None,
    state_of_charge: float | None,
    winding_temperature_K: float | None,
) -> None:
    question.text("rating", "--rating", rating)
    question.number("bus_voltage_V", "--bus-voltage", bus_voltage_V)
    question.number("state_of_charge", "--state-of-charge", state_of_charge)
    question.number("winding_temperature_K", "--winding-temperature", winding_temperature_K)


class Actuator:
    """Motor, drive and gearbox of a document of kind ``actuator``. Made by ``actuator()``.

    ``name`` is the document's name, ``document`` the document. The document's file, where there is
    one, is read again by each question, but for ``clip``: that keeps the region of each set of
    conditions. After a change of the file make another ``Actuator``.
    """

    def __init__(self, source: Source) -> None:
        self.source: Source = copy.deepcopy(source) if isinstance(source, Mapping) else source
        self._clips: dict[tuple[Any, ...], _core.RegionClip] = {}
        self._modules: dict[tuple[Any, ...], Any] = {}
        if isinstance(source, Mapping):
            with Question() as question:
                self.document = question.read("actuator", source)
        else:
            self.document = read(source)
        if self.document["kind"] != "actuator":
            raise refuse(
                "actuator", f"is a document of kind {self.document['kind']}; must be an actuator"
            )
        self.name: str = self.document.get("name", "")

    def __getstate__(self) -> dict[str, Any]:
        """For copies and other processes: their tables are made again when they are asked for."""
        return {**self.__dict__, "_clips": {}, "_modules": {}}

    def __repr__(self) -> str:
        return f"<torquewright.Actuator {self.name!r}>"

    def region(
        self,
        speeds_rad_s: Any = None,
        *,
        bus_voltage_V: float | None = None,
        state_of_charge: float | None = None,
        winding_temperature_K: float | None = None,
        side: str = "joint",
        rating: str = "peak",
    ) -> Result:
        """The motor operating region: which torques the actuator can have, at which speed.

        ``speeds_rad_s``: at these speeds, in their order; without them, at as many as linear
        interpolation needs (where a bound jumps at rest there are two rows at speed 0).
        ``bus_voltage_V``: of the source without load, 0.5 to 2000. ``state_of_charge``: of the
        battery, 0 to 1. ``winding_temperature_K``: 200 to 600. ``side``: ``"joint"``, after the
        gearbox and all losses, or ``"motor"``, at the rotor before friction. ``rating``:
        ``"peak"`` or ``"continuous"``. What is left out is the document's.

        Returns the document of kind ``mor_table`` with its rows as columns: ``speed_rad_s``,
        ``torque_min_Nm``, ``torque_max_Nm``, ``current_min_A``, ``current_max_A``,
        ``bus_power_at_min_W``, ``bus_power_at_max_W`` (arrays) and ``limiter_min``,
        ``limiter_max`` (lists of words). Where the region is empty these numbers are NaN, and the
        limiters say why.

        Raises ``Refusal`` for conditions that are out of range or that the document cannot meet.

        >>> knee = torquewright.actuator("specs/actuator/d151_knee.json")
        >>> knee.region([0.0, 9.1])["torque_max_Nm"]
        array([320. , 204.8])
        """
        with Question("actuator", "mor") as question:
            add_conditions(
                question, rating, bus_voltage_V, state_of_charge, winding_temperature_K
            )
            question.text("side", "--side", side)
            if speeds_rad_s is not None:
                speeds = np.atleast_1d(finite_numbers("speeds_rad_s", speeds_rad_s)).ravel()
                if speeds.size == 0:
                    raise refuse("speeds_rad_s", "is empty; without it the region has its own")
                question.option(
                    "speeds_rad_s", "--at-speed", ",".join(map(repr, speeds.tolist()))
                )
            question.argument(question.document("actuator", self.source))
            table = question.answer()
        return _with_columns(table)

    def clip(
        self,
        torque_Nm: Any,
        speed_rad_s: Any,
        *,
        bus_voltage_V: float | None = None,
        state_of_charge: float | None = None,
        winding_temperature_K: float | None = None,
        side: str = "joint",
        rating: str = "peak",
    ) -> Any:
        """Torques [Nm] cut off at what the actuator can have at those speeds [rad/s].

        ``torque_Nm`` and ``speed_rad_s`` are numbers or arrays of one shape, or of shapes that
        NumPy broadcasts; infinite torques stand for the limit. Conditions as for ``region``. The
        numbers are those of ``torquewright actuator mor --format python``: lines between the rows
        of the region's table, drawn in by what they may be off (2.5e-4 of the peak torque).

        Arrays of other libraries are clipped by themselves: PyTorch in, PyTorch out, on its device
        and of its precision, with slopes; what is no number stays none there.

        Returns an array of floats of that shape; a number for numbers.

        Raises ``Refusal`` for NaN, masked values, shapes that do not go together, and conditions
        as for ``region``.

        >>> knee = torquewright.actuator("specs/actuator/d151_knee.json")
        >>> knee.clip([500.0, -500.0, 10.0], 0.0)
        array([ 320., -320.,   10.])
        """
        conditions = (bus_voltage_V, state_of_charge, winding_temperature_K, side, rating)
        if _is_foreign(speed_rad_s):
            return self._module_of(conditions).clip(torque_Nm, speed_rad_s)
        if _is_foreign(torque_Nm):
            raise refuse("speed_rad_s", "must be of the library of torque_Nm, which is an array of "
                         + type(torque_Nm).__module__.partition(".")[0])
        torques = numbers("torque_Nm", torque_Nm)
        speeds = numbers("speed_rad_s", speed_rad_s)
        if torques.shape != speeds.shape:
            try:
                torques, speeds = np.broadcast_arrays(torques, speeds)
            except ValueError:
                raise refuse(
                    "torque_Nm",
                    f"has the shape {torques.shape}, which does not go with "
                    f"{speeds.shape} of speed_rad_s",
                ) from None
        return self._clip_of(conditions).clip(torques, speeds)[()]

    def need(
        self,
        torque_Nm: float,
        speed_rad_s: float,
        *,
        bus_voltage_V: float | None = None,
        state_of_charge: float | None = None,
        winding_temperature_K: float | None = None,
        rating: str = "peak",
    ) -> Result:
        """Whether the joint can have a torque at a speed, and if not, what would do.

        ``torque_Nm``, ``speed_rad_s``: at the joint. Conditions as for ``region``.

        Returns the document of kind ``mor_need``: ``reached``, ``margin_Nm``, ``limiter``,
        ``would_be_reached_with``.

        Raises ``Refusal`` for numbers out of range.

        >>> torquewright.actuator("specs/actuator/d151_knee.json").need(300.0, 9.1).reached
        False
        """
        torque, speed = (finite_number(*of) for of in
                         (("torque_Nm", torque_Nm), ("speed_rad_s", speed_rad_s)))
        with Question("actuator", "mor") as question:
            add_conditions(
                question, rating, bus_voltage_V, state_of_charge, winding_temperature_K
            )
            question.option("torque_Nm", "--need", f"{torque!r}@{speed!r}")
            question.argument(question.document("actuator", self.source))
            return question.answer()

    def plot(self, axes: Any = None, **conditions: Any) -> Any:
        """The region drawn with matplotlib, on its ``axes`` where given; returns them. Conditions as
        for ``region``."""
        if axes is None:
            from matplotlib import pyplot

            axes = pyplot.gca()
        table = self.region(**conditions)
        speeds, least, greatest = (
            table[name] for name in ("speed_rad_s", "torque_min_Nm", "torque_max_Nm")
        )
        axes.fill_between(speeds, least, greatest, alpha=0.3, label=self.name)
        axes.plot(speeds, least, speeds, greatest)
        axes.set_xlabel("speed [rad/s]")
        axes.set_ylabel("torque [Nm]")
        return axes

    def _module_of(self, conditions: tuple[Any, ...]) -> Any:
        """The exported module, whose clip takes the arrays of any library."""
        if conditions not in self._modules:
            bus_voltage_V, state_of_charge, winding_temperature_K, side, rating = conditions
            with Question("actuator", "mor") as question:
                add_conditions(
                    question, rating, bus_voltage_V, state_of_charge, winding_temperature_K
                )
                question.text("side", "--side", side)
                question.option("format", "--format", "python")
                question.option("friction", "--friction", "limits")
                question.argument(question.document("actuator", self.source))
                module = types.ModuleType("torquewright_region")
                exec(question.printed(), module.__dict__)
            self._modules[conditions] = module
        return self._modules[conditions]

    def _clip_of(self, conditions: tuple[Any, ...]) -> _core.RegionClip:
        if conditions not in self._clips:
            names = ("bus_voltage_V", "state_of_charge", "winding_temperature_K", "side", "rating")
            table = self.region(**dict(zip(names, conditions)))
            there = ~np.isnan(table["torque_min_Nm"])
            self._clips[conditions] = _core.RegionClip(
                table["speed_rad_s"][there],
                table["torque_min_Nm"][there],
                table["torque_max_Nm"][there],
                table["interpolation_error_Nm"],
            )
        return self._clips[conditions]


def actuator(document: Source) -> Actuator:
    """An actuator, to be asked for its ``region`` and to ``clip`` torques.

    ``document``: a file of kind ``actuator``, or the same as a dictionary, whose keys carry their
    units (``resistance_ohm``, ``bus_voltage_V``). Files that a dictionary names are looked for in
    the current folder.

    Raises ``Refusal`` with every fault of the document.

    >>> torquewright.actuator("specs/actuator/d151_knee.json")
    <torquewright.Actuator 'knee D151'>
    """
    return Actuator(document)


def _is_foreign(values: Any) -> bool:
    """Whether these are arrays that NumPy is not to touch."""
    library = type(values).__module__.partition(".")[0]
    return library in ("torch", "jax", "jaxlib", "cupy")


def _with_columns(table: Result) -> Result:
    rows = table.pop("rows")
    for name in _NUMBERS:
        table[name] = np.array([row[name] for row in rows], dtype=np.float64)
    for name in _WORDS:
        table[name] = [row[name] for row in rows]
    return table
