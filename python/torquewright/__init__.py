# SPDX-License-Identifier: Apache-2.0
"""Torquewright from Python: design of actuators and gearboxes for jumping robots.

Calls, which answer what the program `torquewright` answers, in this process:

    read(path)                    a document of any kind, checked, as a dictionary
    schema(kind)                  every key of a kind: meaning, unit, allowed values
    lint(*actuators)              contradictions between stated numbers
    actuator(document)            an Actuator, to be asked:
      .region(speeds_rad_s)         the motor operating region, as arrays
      .clip(torque_Nm, speed_rad_s) torques cut off at that region
      .need(torque_Nm, speed_rad_s) is this torque reached there?
      .plot()                       the region, drawn with matplotlib
    check(motion, joints)         can the actuators do this motion?
    hopper_check(robot, motion)   can the whole robot?
    identify(logs, rig, actuator) is the model true, and which effect is missing?
    optimize(problem)             the best gearbox, proved
    gearbox(problem).optimize()   the same
    strength(gears)               what torques do to the teeth
    flip(robot)                   a flip, a jump or a hop, planned
    replay(robot, motion)         does the robot do the motion, simulated?

Documents are paths or dictionaries, motions and logs are paths or columns of arrays. Units are in
every name. Reports are dictionaries, the same that the program prints with --json, whose keys are
attributes too (Result).

Input that cannot be used raises `Refusal`, a ValueError, with every fault: place, value, what is
allowed. NaN is refused. Ctrl-C ends long work (KeyboardInterrupt); other threads go on meanwhile,
calls that compute a report wait for one another.
"""

from ._actuator import Actuator, actuator
from ._core import version as __version__
from ._documents import read, schema
from ._refusal import Fault, Refusal
from ._reports import check, hopper_check, identify, lint, optimize
from ._results import Result
from ._robots_and_gears import Gearbox, flip, gearbox, replay, strength

__all__ = [
    "Actuator",
    "Fault",
    "Gearbox",
    "Refusal",
    "Result",
    "__version__",
    "actuator",
    "check",
    "flip",
    "gearbox",
    "hopper_check",
    "identify",
    "lint",
    "optimize",
    "read",
    "replay",
    "schema",
    "strength",
]

for _public in (Actuator, Fault, Gearbox, Refusal, Result, actuator, check, flip, gearbox,
                hopper_check, identify, lint, optimize, read, replay, schema, strength):
    _public.__module__ = __name__  # as it is to be imported, and as it is shown
del _public
