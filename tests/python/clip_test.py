# SPDX-License-Identifier: Apache-2.0
"""Torques of arrays, cut off. Oracles: the module that `actuator mor --format python` writes, and
the closed form of a motor without losses."""

import tempfile
import threading
import time
import unittest

import numpy as np

import program
import torquewright

AGREEMENT = 1e-6  # of the peak torque, as the documentation promises
ROUNDING = 1e-9  # Nm: the knee's table is exact but for roundings, and drawn in by them
TABLE = 2.5e-4  # of the peak torque: what lines between rows may be off, and are drawn in by

CONDITIONS = (
    ((), {}),
    (("--bus-voltage", "40"), {"bus_voltage_V": 40}),
    (("--winding-temperature", "370"), {"winding_temperature_K": 370.0}),
    (("--rating", "continuous"), {"rating": "continuous"}),
    (("--side", "motor"), {"side": "motor"}),
)


def samples(region, count=4000):
    """All quadrants, beyond both ends, rest from either side, and every speed of the table."""
    dice = np.random.default_rng(7)
    end = 1.3 * np.abs(region["speed_rad_s"]).max()
    most = 1.5 * np.nanmax(np.abs([region["torque_min_Nm"], region["torque_max_Nm"]]))
    corners = np.repeat(region["speed_rad_s"], 2)
    speeds = np.concatenate([[0.0, 0.0, -0.0, -0.0], corners, dice.uniform(-end, end, count)])
    torques = dice.uniform(-most, most, speeds.size)
    torques[: 4 + corners.size : 2] = most
    torques[1 : 4 + corners.size : 2] = -most
    return torques, speeds, most / 1.5


class Clip(unittest.TestCase):
    def test_is_what_the_exported_module_does(self):
        with tempfile.TemporaryDirectory() as folder:
            self.expect_same((program.KNEE, program.LOSSY, program.rubbing_knee(folder)))

    def expect_same(self, files):
        for file in files:
            drive = torquewright.actuator(file)
            for options, keywords in CONDITIONS:
                with self.subTest(file=file, **keywords):
                    torques, speeds, peak = samples(drive.region(**keywords))
                    theirs = program.exported_module(file, *options).clip(torques, speeds)
                    ours = drive.clip(torques, speeds, **keywords)
                    self.assertGreater(np.abs(ours - torques).max(), 0.1 * peak)
                    np.testing.assert_allclose(ours, theirs, rtol=0, atol=AGREEMENT * peak)

    # No friction, no losses: 20 0.32 (67.2 - 20 0.32 w) / 0.28 within +-20 0.32 50; the line that
    # ends the region on the other side is its mirror image.
    def test_is_the_closed_form_of_a_motor_without_losses(self):
        knee = torquewright.actuator(program.KNEE)
        speeds = np.linspace(-10.5, 10.5, 1001)
        line = 20 * 0.32 * 67.2 / 0.28 - (20 * 0.32) ** 2 / 0.28 * speeds
        greatest = np.minimum(line, 320.0)
        for sign in (1.0, -1.0):
            clipped = knee.clip(sign * 1e4, sign * speeds)
            np.testing.assert_allclose(sign * clipped, greatest, rtol=0, atol=2 * TABLE * 320)
            self.assertTrue((sign * clipped <= greatest + 1e-9).all())  # drawn in, not out
        inside = 0.9 * greatest
        np.testing.assert_allclose(knee.clip(inside, speeds), inside, rtol=0, atol=ROUNDING)

    def test_takes_numbers_arrays_and_what_goes_together(self):
        knee = torquewright.actuator(program.KNEE)
        one = knee.clip(1e4, 0.0)
        self.assertEqual(np.ndim(one), 0)
        self.assertAlmostEqual(one, 320.0, delta=ROUNDING)
        self.assertEqual(knee.clip([1, 2], np.float32(0)).dtype, np.float64)
        self.assertEqual(knee.clip(np.zeros((3, 1)), np.zeros(4)).shape, (3, 4))
        self.assertEqual(knee.clip([], []).shape, (0,))
        swapped = np.asfortranarray(np.linspace(-500, 500, 12).reshape(3, 4))
        for given in (swapped, swapped[:, ::-2], np.array([np.inf, -np.inf])):
            clipped = knee.clip(given, np.zeros(given.shape))
            np.testing.assert_allclose(
                clipped, np.clip(given, -320.0, 320.0), rtol=0, atol=ROUNDING
            )
        given = np.array([1e4])
        knee.clip(given, 0.0)
        self.assertEqual(given[0], 1e4)  # what is given stays

    def test_refuses_what_is_no_number(self):
        knee = torquewright.actuator(program.KNEE)
        for torques, speeds, sentence in (
            ([1.0, np.nan], 0.0, "torque_Nm[1]: is nan; must be a number"),
            (1.0, [[0.0, 1.0], [np.nan, 0.0]], "speed_rad_s[1, 0]: is nan; must be a number"),
            (np.nan, 0.0, "torque_Nm: is nan; must be a number"),
            ("many", 0.0, "torque_Nm: holds <U4; must be real numbers"),
            (1j, 0.0, "torque_Nm: holds complex128; must be real numbers"),
            ([None], 0.0, "torque_Nm: holds object; must be real numbers"),
            (
                np.ma.masked_array([1.0, 2.0], [False, True]),
                0.0,
                "torque_Nm: has masked values; every value must be a number",
            ),
            (
                [1.0, 2.0],
                [1.0, 2.0, 3.0],
                "torque_Nm: has the shape (2,), which does not go with (3,) of speed_rad_s",
            ),
        ):
            with self.assertRaises(torquewright.Refusal) as raised:
                knee.clip(torques, speeds)
            self.assertEqual(str(raised.exception), sentence)

    # In the middle half of a call of the compiled part, which is no line of Python: the other
    # thread cannot have gone on before it or behind it. Busy machines may need more than one.
    def test_lets_other_threads_go_on(self):
        knee = torquewright.actuator(program.KNEE)
        knee.clip(0.0, 0.0)
        compiled = next(iter(knee._clips.values()))
        torques = np.linspace(-500.0, 500.0, 2_000_000)
        speeds = np.full_like(torques, 3.0)
        steps, over = [], threading.Event()

        def go_on():
            while not over.is_set():
                steps.append(time.monotonic())
                time.sleep(0)

        thread = threading.Thread(target=go_on)
        thread.start()
        is_found = False
        for _ in range(100):
            steps.clear()
            begin = time.monotonic()
            compiled.clip(torques, speeds)
            end = time.monotonic()
            quarter = (end - begin) / 4
            is_found = any(begin + quarter < step < end - quarter for step in list(steps))
            if is_found:
                break
        over.set()
        thread.join()
        self.assertTrue(is_found)


if __name__ == "__main__":
    unittest.main()
