# SPDX-License-Identifier: Apache-2.0
"""Reports as dictionaries. Oracle: what the program prints with --json for the same documents."""

import csv
import pathlib
import tempfile
import threading
import unittest

import numpy as np

import program
import torquewright

MOTION = "specs/trajectory/knee_extension.csv"
PROBLEM = "specs/gearbox/d151_knee.json"
BENCH = ("specs/log/bench_as_built.csv", "specs/log/bench_rig.json", "specs/log/bench_actuator.json")
HOPPER = ("specs/robot/hopper.json", "specs/trajectory/hopper_squat.csv")


def columns_of(file):
    """A CSV file as arrays by name."""
    with open(program.ROOT / file, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    columns = {name: [row[name] for row in rows] for name in rows[0]}
    runs = columns.pop("run", None)
    arrays = {name: np.array(values, dtype=float) for name, values in columns.items()}
    return arrays | ({"run": runs} if runs else {})


def without_inputs(report):
    return {key: value for key, value in report.items() if key != "inputs"}


class Lint(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        files = (program.LOSSY, "specs/actuator/mini_cheetah_knee.json")
        self.assertEqual(torquewright.lint(*files), program.printed("actuator", "lint", *files))

    def test_takes_dictionaries_and_actuators(self):
        drive = torquewright.actuator(program.LOSSY)
        report = torquewright.lint(drive, torquewright.read("specs/actuator/mini_cheetah_knee.json"))
        expected = torquewright.lint(program.LOSSY, "specs/actuator/mini_cheetah_knee.json")
        self.assertEqual(without_inputs(report), without_inputs(expected))
        self.assertEqual([one["path"] for one in report["inputs"]], [program.LOSSY, "actuator_2"])


class Check(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        report = torquewright.check(MOTION, {"knee": program.KNEE})
        words = ("actuator", "check", MOTION, "--joint", "knee=" + program.KNEE)
        self.assertEqual(report, program.printed(*words))
        report = torquewright.check(
            MOTION,
            {"knee": torquewright.actuator(program.KNEE)},
            bus_voltage_V=50,
            rating="continuous",
            until_s=0.3,
            torque_includes_inertia=True,
            repeat=3,
            pause_s=0.5,
        )
        words += ("--bus-voltage", "50", "--rating", "continuous", "--until", "0.3", "--repeat", "3")
        words += ("--pause", "0.5", "--torque-includes-inertia")
        self.assertEqual(report, program.printed(*words))

    def test_takes_arrays_and_dictionaries(self):
        document = torquewright.read(program.KNEE)
        report = torquewright.check(columns_of(MOTION), {"knee": document})
        expected = torquewright.check(MOTION, {"knee": program.KNEE})
        self.assertEqual(without_inputs(report), without_inputs(expected))
        self.assertEqual([one["path"] for one in report["inputs"]], ["motion", "actuator_knee"])

    def test_keeps_joints_apart_whose_names_are_alike(self):
        # Oracle, by hand: N Kt I = 20 x 0.32 x 5 = 32 and 20 x 0.32 x 50 = 320 Nm, 200 asked for.
        weak = torquewright.read(program.KNEE)
        weak["drive"] |= {"continuous_current_A": 5, "peak_current_A": 5}
        drives = {"a b": (weak, -168), "a_b": (program.KNEE, 120), "k" * 300: (weak, -168)}
        motion = {"time_s": [0.0, 0.1, 0.2]}
        for name in drives:
            motion[f"{name}_position_rad"] = [0.0, 0.01, 0.02]
            motion[f"{name}_velocity_rad_s"] = [0.1, 0.1, 0.1]
            motion[f"{name}_torque_Nm"] = [200.0, 200.0, 200.0]
        asked = {name: torquewright.actuator(drive) for name, (drive, _) in drives.items()}
        report = torquewright.check(motion, asked, torque_includes_inertia=True)
        for joint, (name, (_, margin_Nm)) in zip(report["joints"], drives.items(), strict=True):
            self.assertEqual(joint["name"], name)
            self.assertAlmostEqual(joint["margin_Nm"], margin_Nm, places=9)

    def test_takes_other_names_and_units(self):
        columns = columns_of(MOTION)
        named = {"t": 1e3 * columns["time_s"], "q": columns["knee_position_rad"]}
        named["v"] = columns["knee_velocity_rad_s"]
        named["m"] = columns["knee_torque_Nm"]
        report = torquewright.check(
            named,
            {"knee": program.KNEE},
            columns=["t=time:ms", "q=knee.position", "v=knee.velocity", "m=knee.torque"],
        )
        expected = torquewright.check(columns, {"knee": program.KNEE})
        self.assertEqual(report["verdict"], expected["verdict"])
        self.assertAlmostEqual(
            report["joints"][0]["margin_Nm"], expected["joints"][0]["margin_Nm"], delta=1e-6
        )


class HopperCheck(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        self.assertEqual(
            torquewright.hopper_check(*HOPPER, until_s=0.2, bus_voltage_V=50),
            program.printed("hopper", "check", *HOPPER, "--until", "0.2", "--bus-voltage", "50"),
        )

    def test_takes_arrays_and_dictionaries(self):
        robot = torquewright.read(HOPPER[0])
        with self.assertRaises(torquewright.Refusal):  # its actuators lie beside the file
            torquewright.hopper_check(robot, HOPPER[1])
        folder = program.ROOT / "specs/robot"
        for mechanism in robot["mechanisms"]:
            mechanism["actuators"] = [str(folder / one) for one in mechanism["actuators"]]
            limit = mechanism["transmission_limit"]
            if "strength" in limit:
                limit["strength"] = str(folder / limit["strength"])
        report = torquewright.hopper_check(robot, columns_of(HOPPER[1]))
        expected = torquewright.hopper_check(*HOPPER)
        self.assertEqual(report["verdict"], expected["verdict"])
        self.assertEqual(report["joints"], expected["joints"])


class Identify(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.report = torquewright.identify(*BENCH)

    def test_is_what_the_program_prints(self):
        log, rig, actuator = BENCH
        words = ("identify", log, "--rig", rig, "--actuator", actuator)
        self.assertEqual(self.report, program.printed(*words))

    def test_takes_arrays_and_dictionaries_and_writes_the_refined_actuator(self):
        log, rig, actuator = BENCH
        with tempfile.TemporaryDirectory() as folder:
            refined = pathlib.Path(folder) / "refined.json"
            report = torquewright.identify(
                [columns_of(log)], torquewright.read(rig), torquewright.read(actuator),
                refined=refined,
            )
            effects = [one["effect"] for one in torquewright.read(refined)["effects"]]
        self.assertEqual(report["effects_added"], self.report["effects_added"])
        self.assertEqual(report["verdict"], self.report["verdict"])
        for added in report["effects_added"]:
            self.assertIn(added["effect"], effects)

    def test_names_only_what_may_be_named(self):
        added = self.report["effects_added"][0]["effect"]
        log, rig, actuator = BENCH
        report = torquewright.identify(log, rig, torquewright.actuator(actuator), without=[added])
        self.assertNotIn(added, [one["effect"] for one in report["effects_added"]])


class Optimize(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        self.assertEqual(
            torquewright.optimize(PROBLEM, top=3, verify=True),
            program.printed("gearbox", "optimize", PROBLEM, "--top", "3", "--verify"),
        )

    def test_takes_a_dictionary_and_says_what_is_infeasible(self):
        problem = torquewright.read(PROBLEM)
        report = torquewright.optimize(problem)
        expected = torquewright.optimize(PROBLEM)
        self.assertEqual(without_inputs(report), without_inputs(expected))
        problem["min_teeth"]["sun"] = 400
        self.assertEqual(torquewright.optimize(problem)["status"], "infeasible")

    def test_ends_where_it_is_told_to(self):
        self.assertEqual(torquewright.optimize(PROBLEM, max_nodes=1)["status"], "limit")


class Threads(unittest.TestCase):
    def test_get_their_own_answers(self):
        expected = {top: torquewright.optimize(PROBLEM, top=top) for top in (1, 2, 3, 4)}
        found = {}

        def ask(top):
            found[top] = torquewright.optimize(PROBLEM, top=top)

        threads = [threading.Thread(target=ask, args=(top,)) for top in expected]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, expected)


if __name__ == "__main__":
    unittest.main()
