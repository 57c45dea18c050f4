# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C in long work. Oracle: Python's own handler of SIGINT, which raises KeyboardInterrupt in
the main thread, and which is the same afterwards."""

import os
import signal
import threading
import time
import unittest

import program
import torquewright

BENCH = ("specs/log/bench_as_built.csv", "specs/log/bench_rig.json", "specs/log/bench_actuator.json")


def long_problem():
    """Keeps the search busy for many minutes: a wide bore and tolerance, an objective with roots.
    What does not end it is ended by the patience of CTest."""
    problem = torquewright.read("specs/gearbox/d151_knee.json")
    problem.update(rotor_inner_diameter_mm=2000, module_mm=1, ratio_tolerance=0.05)
    return problem | {"objective": "forward_efficiency"}


class Interrupt(unittest.TestCase):
    def interrupt_soon(self, seconds):
        timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        self.addCleanup(timer.join)

    def expect_interrupted(self, work):
        before = signal.getsignal(signal.SIGINT)
        self.interrupt_soon(0.5)
        with self.assertRaises(KeyboardInterrupt):
            work()
        self.assertIs(signal.getsignal(signal.SIGINT), before)

    def test_ends_a_search(self):
        self.expect_interrupted(lambda: torquewright.optimize(long_problem()))

    # Work that has no answer before its end is left where it shows its progress.
    def test_ends_an_identification(self):
        rig, actuator = torquewright.read(BENCH[1]), torquewright.actuator(BENCH[2])

        def work():
            while True:  # one takes less than the signal's patience
                torquewright.identify(BENCH[0], rig, actuator)

        self.expect_interrupted(work)

    # What the function raises comes out, as Ctrl-C does: work is left where it shows its progress.
    def test_progress_is_heard_and_ends_the_work(self):
        heard = []

        def listen(text):
            heard.append(text)
            if len(heard) == 3:
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            torquewright.optimize(long_problem(), progress=listen)
        self.assertEqual(len(heard), 3)
        self.assertTrue(all(isinstance(text, str) and text for text in heard))
        with self.assertRaisesRegex(torquewright.Refusal, "progress: is 3; must be a function"):
            torquewright.optimize(long_problem(), progress=3)

    def test_progress_asks_no_question_itself(self):
        def ask(text):
            torquewright.lint(BENCH[2])

        with self.assertRaisesRegex(RuntimeError, "may ask no question itself"):
            torquewright.optimize(long_problem(), progress=ask)

    def test_leaves_the_interpreter_as_it_was(self):
        with self.assertRaises(KeyboardInterrupt):
            self.interrupt_soon(0.2)
            torquewright.optimize(long_problem())
        report = torquewright.optimize("specs/gearbox/d151_knee.json")  # not interrupted any more
        self.assertEqual(report["status"], "optimal")
        with self.assertRaises(KeyboardInterrupt):
            self.interrupt_soon(0.1)
            time.sleep(60.0)

    def test_reaches_work_in_another_thread(self):
        ended = []

        def work():
            try:
                torquewright.optimize(long_problem())
            except KeyboardInterrupt:
                ended.append("interrupted")

        thread = threading.Thread(target=work)
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            self.interrupt_soon(0.5)
            time.sleep(60.0)
        thread.join()
        self.assertEqual(ended, ["interrupted"])


if __name__ == "__main__":
    unittest.main()
