# SPDX-License-Identifier: Apache-2.0
"""What cannot be used is refused, in the program's sentences. Oracle: the program's stderr, and the
sentence as it must stand."""

import copy
import pickle
import unittest

import numpy as np

import program
import torquewright

MOTION = "specs/trajectory/knee_extension.csv"


class Refusals(unittest.TestCase):
    def refusal_of(self, call, *arguments, **keywords):
        with self.assertRaises(torquewright.Refusal) as raised:
            call(*arguments, **keywords)
        return raised.exception

    def expect(self, sentence, call, *arguments, **keywords):
        self.assertEqual(str(self.refusal_of(call, *arguments, **keywords)), sentence)

    def test_are_value_errors_with_their_faults(self):
        document = torquewright.read(program.KNEE)
        document["motor"]["resistance_ohm"] = -1
        document["motor"]["resistence"] = 1
        refusal = self.refusal_of(torquewright.actuator, document)
        self.assertIsInstance(refusal, ValueError)
        faults = {fault.path: fault for fault in refusal.faults}
        self.assertEqual(set(faults), {"/motor/resistance_ohm", "/motor/resistence"})
        self.assertEqual({fault.file for fault in refusal.faults}, {"actuator"})
        self.assertIn("-1", faults["/motor/resistance_ohm"].message)
        self.assertIn("resistance_ohm", faults["/motor/resistence"].message)
        self.assertEqual(str(pickle.loads(pickle.dumps(refusal))), str(refusal))

    def test_are_of_names_that_no_joint_can_have(self):
        for name in ("", "knee=left"):
            self.expect(
                f"joints: has the name {name!r}; must be one letter or more, without \"=\"",
                torquewright.check, MOTION, {name: program.KNEE},
            )

    def test_are_the_sentences_of_the_program(self):
        for words, call, arguments in (
            (("actuator", "lint", program.KNEE, MOTION), torquewright.lint, (program.KNEE, MOTION)),
            (("gearbox", "optimize", program.KNEE), torquewright.optimize, (program.KNEE,)),
            (("gearbox", "optimize", "specs"), torquewright.optimize, ("specs",)),
            (
                ("hopper", "check", "specs/robot/hopper.json", MOTION),
                torquewright.hopper_check,
                ("specs/robot/hopper.json", MOTION),
            ),
        ):
            code, _, err = program.run(*words)
            self.assertEqual(code, 2)
            self.assertEqual(str(self.refusal_of(call, *arguments)) + "\n", err)

    def test_name_arguments_as_they_are_called_here(self):
        knee = torquewright.actuator(program.KNEE)
        for keywords, place in (
            ({"bus_voltage_V": 3000}, "bus_voltage_V: "),
            ({"winding_temperature_K": 20}, "winding_temperature_K: "),
            ({"state_of_charge": 2}, "state_of_charge: "),
            ({"side": "left"}, "side: "),
            ({"rating": "best"}, "rating: "),
            ({"speeds_rad_s": 1e9}, "speeds_rad_s: "),
        ):
            sentence = str(self.refusal_of(knee.region, **keywords))
            self.assertTrue(sentence.startswith(place), sentence)
            self.assertNotIn("--", sentence)
        self.expect(
            'bus_voltage_V: "3000.0" is not a number from 0.5 to 2000', knee.region, bus_voltage_V=3000
        )

    def test_meet_numbers_that_are_none(self):
        knee = torquewright.actuator(program.KNEE)
        nan, inf = float("nan"), float("inf")
        self.expect("bus_voltage_V: is nan; must be finite", knee.region, bus_voltage_V=nan)
        self.expect("bus_voltage_V: is inf; must be finite", knee.clip, 1, 0, bus_voltage_V=inf)
        self.expect("bus_voltage_V: is 'much'; must be a number", knee.region, bus_voltage_V="much")
        self.expect("speeds_rad_s[1]: is nan; must be a number", knee.region, [0, nan])
        self.expect("speeds_rad_s[0]: is inf; must be finite", knee.region, [inf])
        self.expect("speeds_rad_s: is empty; without it the region has its own", knee.region, [])
        document = copy.deepcopy(knee.document)
        document["motor"]["resistance_ohm"] = nan
        self.expect(
            "actuator#/motor/resistance_ohm: is nan; must be finite", torquewright.actuator, document
        )
        self.expect("top: is 1.5; must be a whole number", torquewright.optimize, "x", top=1.5)
        self.expect("pause_s: is nan; must be finite", torquewright.check, MOTION, {}, pause_s=nan)

    def test_meet_motions_that_are_none(self):
        joints = {"knee": program.KNEE}
        motion = {"time_s": [0.0, 0.1], "knee_velocity_rad_s": [0.0, 0.0], "knee_torque_Nm": [1.0]}
        self.expect(
            "motion['knee_torque_Nm']: has the shape (1,); must be one number for each of the 2 "
            "samples of 'time_s'",
            torquewright.check, motion, joints,
        )
        motion["knee_torque_Nm"] = [1.0, np.nan]
        self.expect(
            "motion['knee_torque_Nm'][1]: is nan; must be a number",
            torquewright.check, motion, joints,
        )
        self.expect("motion: has no columns", torquewright.check, {}, joints)
        self.expect(
            "motion: is a int; must be a path or a dictionary", torquewright.check, 3, joints
        )

    def test_meet_what_is_no_document(self):
        for source in (None, 3, 2.5, ["a"]):
            refusal = self.refusal_of(torquewright.actuator, source)
            self.assertIn("must be a path or a dictionary", str(refusal))
        self.expect(
            "actuator: is a document of kind rig; must be an actuator",
            torquewright.actuator, "specs/rig/pendulum.json",
        )
        self.expect(
            "joints: must be a dictionary with the actuator of each joint by its name",
            torquewright.check, MOTION, program.KNEE,
        )
        self.expect(
            "actuators: is missing; must be one or more", torquewright.lint
        )
        self.assertIn("actuator", str(self.refusal_of(torquewright.actuator, {})))
        endless = {"kind": "actuator"}
        endless["motor"] = endless
        self.assertIn("is no document", str(self.refusal_of(torquewright.actuator, endless)))

    # Words that a command line would take for an option, or cut short.
    def test_meet_strange_paths(self):
        for path in ("--json", "--help", "-o", "", "none\0sense", "a\nb", "\udcff"):
            for call in (torquewright.read, torquewright.lint, torquewright.optimize):
                self.refusal_of(call, path)

    def test_stay_on_their_lines(self):
        _, _, err = program.run("gearbox", "optimize", "no\nsuch\x7ffile é")
        refusal = self.refusal_of(torquewright.optimize, "no\nsuch\x7ffile é")
        self.assertEqual(str(refusal) + "\n", err)
        self.assertEqual(len(str(refusal).splitlines()), 1)

    def test_name_effects_that_are_not_known(self):
        log, rig = "specs/log/bench_as_built.csv", "specs/log/bench_rig.json"
        refusal = self.refusal_of(
            torquewright.identify, log, rig, "specs/log/bench_actuator.json", only=["friction"]
        )
        self.assertTrue(str(refusal).startswith('only: no effect is called "friction"'), refusal)


if __name__ == "__main__":
    unittest.main()
