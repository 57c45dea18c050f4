# SPDX-License-Identifier: Apache-2.0
"""What help and docs/python.md show is what comes out; every call names units and errors. Oracle:
doctest, which runs each example as it stands."""

import doctest
import inspect
import os
import pathlib
import subprocess
import sys
import unittest

import program
import torquewright

FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
CALLS = [getattr(torquewright, name) for name in torquewright.__all__ if name[0].islower()] + [
    torquewright.Actuator.region,
    torquewright.Actuator.clip,
    torquewright.Actuator.need,
]
UNITS = ("_rad_s", "_Nm", "_V", "_K", "_rad", "_mm", "_ohm", "unit", "[Nm]")


class Help(unittest.TestCase):
    def test_names_units_and_errors_of_each_call(self):
        self.assertEqual(len(CALLS), 15)
        for call in CALLS:
            text = inspect.getdoc(call)
            self.assertTrue(any(unit in text for unit in UNITS), call)
            self.assertIn("Raises ``Refusal``", text, call)
            self.assertIn(">>> ", text, call)
            # "Conditions as for region", "the others as for check": what is said there holds.
            said = text + "".join(
                inspect.getdoc(other)
                for other in (torquewright.Actuator.region, torquewright.check)
                if f"as for ``{other.__qualname__}``" in text or f"as for ``{other.__name__}``" in text
            )
            for name in inspect.signature(call).parameters:
                self.assertTrue(name == "self" or f"``{name}``" in said, (call, name))

    def test_of_the_package_names_each_call(self):
        for call in CALLS:
            self.assertIn(call.__name__ + "(", torquewright.__doc__)

    def test_shows_what_comes_out(self):
        runner = doctest.DocTestRunner(optionflags=FLAGS)
        for call in CALLS:
            names = {"torquewright": torquewright}
            tests = doctest.DocTestFinder().find(call, call.__name__, globs=names)
            for test in tests:
                runner.run(test)
        self.assertEqual(runner.failures, 0)
        self.assertGreaterEqual(runner.tries, 10)


class Page(unittest.TestCase):
    def test_shows_what_comes_out(self):
        page = program.ROOT / "docs/python.md"
        failures, tries = doctest.testfile(str(page), module_relative=False, optionflags=FLAGS)
        self.assertEqual(failures, 0)
        self.assertGreaterEqual(tries, 10)

    def test_has_each_call(self):
        text = (program.ROOT / "docs/python.md").read_text()
        for call in CALLS:
            self.assertRegex(text, rf"[.`]{call.__name__}\(")


class Example(unittest.TestCase):
    def test_runs(self):
        script = program.ROOT / "examples/python/first_hour.py"
        done = subprocess.run(
            [sys.executable, "-B", script], capture_output=True, text=True, cwd=program.ROOT,
            env=os.environ, check=False,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = script.read_text()
        expected = [line[3:] for line in text.splitlines() if line.startswith("#> ")]
        self.assertEqual(expected, done.stdout.splitlines())


class Version(unittest.TestCase):
    def test_is_that_of_the_program(self):
        _, out, _ = program.run("--version")
        self.assertEqual(torquewright.__version__, out.split()[-1])


if __name__ == "__main__":
    unittest.main()
