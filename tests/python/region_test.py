# SPDX-License-Identifier: Apache-2.0
"""The region as arrays. Oracles: what the program prints, and the closed form of a motor without
losses (320 Nm cap; corner (67.2 - 0.28 50) / (20 0.32) = 8.3125 rad/s; no load 10.5 rad/s)."""

import copy
import json
import os
import pathlib
import tempfile
import unittest

import numpy as np

import program
import torquewright


def rows_of(region):
    """The columns as the rows of documents of kind mor_table."""
    names = [name for name in region if name.endswith(("_rad_s", "_Nm", "_A", "_W"))]
    names = [name for name in names if name != "interpolation_error_Nm"]
    names += ["limiter_min", "limiter_max"]
    rows = []
    for values in zip(*(region[name] for name in names)):
        row = dict(zip(names, values))
        rows.append({k: None if v != v else v for k, v in row.items()})
    return rows


class Region(unittest.TestCase):
    def expect_same(self, region, words):
        document = program.printed("actuator", "mor", *words)
        rows = [{k: v for k, v in row.items() if k != "plugging"} for row in document.pop("rows")]
        self.assertEqual(rows_of(region), rows)
        self.assertEqual({key: region[key] for key in document}, document)

    def test_is_what_the_program_prints(self):
        for file in (program.KNEE, program.LOSSY):
            drive = torquewright.actuator(file)
            self.expect_same(drive.region(), [file])
            self.expect_same(
                drive.region(
                    [3.0, 0.0, -2.5, 1e5],
                    bus_voltage_V=40,
                    winding_temperature_K=350,
                    rating="continuous",
                    side="motor",
                ),
                [file, "--at-speed=3,0,-2.5,1e5", "--bus-voltage", "40", "--rating", "continuous"]
                + ["--winding-temperature", "350", "--side", "motor"],
            )

    def test_is_the_closed_form_of_a_motor_without_losses(self):
        speeds = np.linspace(0.0, 10.5, 22)
        region = torquewright.actuator(program.KNEE).region(speeds)
        line = 20 * 0.32 * (67.2 - 20 * 0.32 * speeds) / 0.28
        np.testing.assert_allclose(
            region["torque_max_Nm"], np.minimum(line, 320.0), rtol=0, atol=1e-9 * 320
        )
        expected = ["current" if speed < 8.3125 else "voltage" for speed in speeds]
        self.assertEqual(region["limiter_max"], expected)

    def test_is_nan_where_nothing_is_allowed(self):
        region = torquewright.actuator(program.KNEE).region(1e6)
        self.assertTrue(np.isnan(region["torque_max_Nm"]).all())
        self.assertEqual(region["limiter_max"], ["voltage"])

    def test_is_that_of_a_dictionary_too(self):
        document = torquewright.read(program.KNEE)
        given = copy.deepcopy(document)
        drive = torquewright.actuator(document)
        document["drive"]["peak_current_A"] = 1.0  # ours by now
        np.testing.assert_array_equal(drive.region(0)["torque_max_Nm"], [320.0])
        self.assertEqual(drive.document, given)
        self.assertEqual(drive.name, "knee D151")

    def test_takes_numbers_of_numpy_in_a_dictionary(self):
        document = torquewright.read(program.KNEE)
        document["drive"]["peak_current_A"] = np.float64(25)
        document["motor"]["pole_pairs"] = np.int64(21)
        self.assertEqual(torquewright.actuator(document).region(0)["torque_max_Nm"], [160.0])

    # A file that a document in memory names is looked for where the user is.
    def test_finds_the_gearbox_of_a_dictionary(self):
        document = torquewright.read(program.KNEE)
        with tempfile.TemporaryDirectory(dir=program.ROOT / "build") as folder:
            gearbox = torquewright.read("specs/gearbox/d151_knee_result.json")
            (pathlib.Path(folder) / "gears.json").write_text(json.dumps(gearbox))
            document["gearbox"] = {"file": "gears.json"}
            document.pop("assumed", None)
            here = os.getcwd()
            os.chdir(folder)
            try:
                in_memory = torquewright.actuator(document).region(0)
                pathlib.Path("drive.json").write_text(json.dumps(document))
                of_file = torquewright.actuator("drive.json").region(0)
            finally:
                os.chdir(here)
        self.assertEqual(in_memory["torque_max_Nm"], of_file["torque_max_Nm"])


if __name__ == "__main__":
    unittest.main()
