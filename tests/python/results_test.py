# SPDX-License-Identifier: Apache-2.0
"""Reports with attributes, and the calls beside the first ten. Oracles: what the program prints;
the closed form of the knee, whose line falls to 1536 (1 - 9.1 / 10.5) = 204.8 Nm at 9.1 rad/s."""

import copy
import importlib.util
import pickle
import unittest

import numpy as np
import program
import torquewright as tw


class Results(unittest.TestCase):
    def test_have_attributes_and_stay_dictionaries(self):
        need = tw.actuator(program.KNEE).need(200.0, 9.1)
        self.assertTrue(need.reached)
        self.assertAlmostEqual(need.margin_Nm, 4.8, places=6)
        self.assertEqual(need.region.torque_max_Nm, need["region"]["torque_max_Nm"])
        self.assertEqual(dict(need)["kind"], "mor_need")
        self.assertIn("margin_Nm", dir(need))
        with self.assertRaisesRegex(AttributeError, "no 'margin'; it has kind"):
            need.margin
        self.assertFalse(tw.actuator(program.KNEE).need(300.0, 9.1).reached)

    def test_are_tables_in_notebooks(self):
        report = tw.Result({"a_Nm": 1.23456789, "text": "<b>", "many": [0.0] * 20})
        text = report._repr_html_()
        self.assertIn("<th>a_Nm</th><td>1.23457</td>", text)
        self.assertIn("&lt;b&gt;", text)
        self.assertIn("20 of them", text)

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "python3-pandas is not installed")
    def test_become_frames(self):
        frame = tw.actuator(program.KNEE).region([0.0, 9.1]).frame()
        self.assertAlmostEqual(frame["torque_max_Nm"][1], 204.8, places=6)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "python3-matplotlib is not installed")
    def test_are_drawn(self):
        import matplotlib

        matplotlib.use("Agg")
        axes = tw.actuator(program.KNEE).plot()
        self.assertEqual(axes.get_ylabel(), "torque [Nm]")

    @unittest.skipUnless(importlib.util.find_spec("torch"), "python3-torch is not installed")
    def test_clip_answers_tensors_with_tensors(self):
        import torch

        speed = torch.tensor([9.1, -9.1], requires_grad=True)
        clipped = tw.actuator(program.KNEE).clip(torch.tensor([500.0, -500.0]), speed)
        self.assertEqual(clipped.dtype, torch.float32)
        np.testing.assert_allclose(clipped.detach().numpy(), [204.8, -204.8], rtol=1e-6)
        clipped.sum().backward()
        np.testing.assert_allclose(speed.grad.numpy(), [-1536 / 10.5] * 2, rtol=1e-6)

    def test_clip_refuses_arrays_of_two_libraries(self):
        foreign = type("Tensor", (), {"__module__": "torch"})()
        with self.assertRaisesRegex(tw.Refusal, "speed_rad_s: must be of the library of torque_Nm"):
            tw.actuator(program.KNEE).clip(foreign, 9.1)

    def test_actuators_are_copied_and_go_to_other_processes(self):
        knee = tw.actuator(program.KNEE)
        knee.clip(1.0, 0.0)
        for other in (copy.deepcopy(knee), pickle.loads(pickle.dumps(knee))):
            self.assertAlmostEqual(float(other.clip(500.0, 9.1)), 204.8, places=6)

    def test_flips_without_a_file_hold_their_motion(self):
        heard = []
        report = tw.flip("specs/robot/hopper.json", task="jump", progress=heard.append)
        self.assertEqual(report.status, "planned")
        self.assertTrue(heard)
        self.assertEqual(tw.hopper_check("specs/robot/hopper.json", report.motion).verdict, "pass")

    def test_are_those_of_the_program(self):
        problem = "specs/gearbox/d151_knee.json"
        self.assertEqual(tw.gearbox(problem).optimize().designs[0].teeth.sun, 44)
        gears = "specs/gearbox/d151_strength.json"
        words = ("gearbox", "strength", gears, "--torque=21")
        self.assertEqual(dict(tw.strength(gears, torque_Nm=[21.0])), program.printed(*words))

    # Plans and replays take seconds: the tests of both are the program's, here only that each word
    # reaches it.
    def test_plans_and_replays_are_asked_with_their_words(self):
        robot, motion = "specs/robot/hopper.json", "specs/trajectory/hopper_squat.csv"
        for call, said in (
            (lambda: tw.flip(robot, task="dance"), "task: "),
            (lambda: tw.flip(robot, limits="none"), "limits: "),
            (lambda: tw.replay(robot, motion, engine="none"), "engine: "),
            (lambda: tw.replay(robot, motion, controller="none"), "controller: "),
            (lambda: tw.replay(robot, motion, trials=1.5), "trials: is 1.5; must be a whole number"),
            (lambda: tw.replay(robot, {"kind": "policy"}), "motion: is the dictionary of a policy"),
        ):
            with self.assertRaises(tw.Refusal) as raised:
                call()
            self.assertTrue(str(raised.exception).startswith(said), raised.exception)


if __name__ == "__main__":
    unittest.main()
