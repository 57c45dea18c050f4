# SPDX-License-Identifier: Apache-2.0
"""Documents and schemas. Oracle: the files, read by Python's own json."""

import json
import unittest

import program
import torquewright

EXAMPLES = ("actuator", "gearbox", "rig", "robot", "randomisation", "log")


class Read(unittest.TestCase):
    def test_is_what_the_file_holds(self):
        files = [file for name in EXAMPLES for file in (program.ROOT / "specs" / name).glob("*.json")]
        self.assertGreater(len(files), 20)
        for file in files:
            self.assertEqual(torquewright.read(file), json.loads(file.read_text()), file)
            self.assertEqual(torquewright.read(str(file)), torquewright.read(file))

    def test_is_refused_as_the_program_refuses(self):
        with self.assertRaises(torquewright.Refusal) as raised:
            torquewright.read("specs/none.json")
        _, _, err = program.run("actuator", "lint", "specs/none.json")
        self.assertEqual(str(raised.exception) + "\n", err)


class Schema(unittest.TestCase):
    def test_is_what_the_program_prints(self):
        for file in (program.ROOT / "specs/schema").glob("*.json"):
            _, out, _ = program.run("schema", file.stem)
            self.assertEqual(torquewright.schema(file.stem), json.loads(out))

    def test_lists_the_kinds_where_there_is_none(self):
        for kind in ("actor", "--help", "-V", ""):
            with self.assertRaises(torquewright.Refusal) as raised:
                torquewright.schema(kind)
            self.assertIn("gearbox_problem", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
