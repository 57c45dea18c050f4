# SPDX-License-Identifier: Apache-2.0
"""Runs the program and remembers what it answered, so that plans of a run that was broken off
can be taken by the next one (`--keep`)."""
import json
import pathlib
import shlex
import subprocess
import time

ROBOT = "specs/robot/hopper.json"


class Program:
    """The program, and the folder in which its answers stay."""

    def __init__(self, path, folder, time_limit_s, trials, keeps=False):
        self.path = path
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.time_limit_s = time_limit_s
        self.trials = trials
        self.keeps = keeps
        self.plans = {}

    def run(self, *arguments):
        """Its text and exit code; more than 3 ends the study."""
        command = [self.path, *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode not in (0, 1, 2, 3):
            raise SystemExit(f"{shlex.join(command)} ends with {done.returncode}:\n{done.stderr}")
        return done.stdout, done.stderr, done.returncode

    def answer(self, name, *arguments):
        """The document that a command with --json prints; None where it refuses, with the words in
        NAME.txt. A file in the folder afterwards."""
        text, words, code = self.run(*arguments, "--json")
        (self.folder / f"{name}.txt").write_text(words)
        if code == 2 or not text:
            return None
        (self.folder / f"{name}.answer.json").write_text(text)
        return json.loads(text)

    def needed(self, name, *arguments):
        """An answer without which the study ends, in the program's words."""
        found = self.answer(name, *arguments)
        if found is None:
            raise SystemExit(f"{name} is refused: {(self.folder / f'{name}.txt').read_text()}"
                             "A plan that the time limit cut short (--time-limit) cannot be studied further.")
        return found

    def plan(self, name, robot=ROBOT, *options):
        """A plan as NAME.csv, or the motion that comes closest as NAME.best.csv; with `motion` the
        file's path and with `seconds` what it took. Of one name only the first is searched for."""
        if name not in self.plans:
            kept = self.folder / f"{name}.found.json"
            if not (self.keeps and kept.exists()):
                kept.write_text(json.dumps(self.search(name, robot, *options)))
            self.plans[name] = json.loads(kept.read_text())
        return self.plans[name]

    def search(self, name, robot, *options):
        plan, best = self.folder / f"{name}.csv", self.folder / f"{name}.best.csv"
        for path in (plan, best):
            path.unlink(missing_ok=True)
        begin = time.monotonic()
        found = self.answer(name, "hopper", "flip", robot, "-o", plan, "--write-best", best,
                            "--time-limit", self.time_limit_s, *options)
        if found is None:
            words = (self.folder / f"{name}.txt").read_text().strip().splitlines()
            return {"status": "refused", "reason": words[0] if words else "", "motion": None, "seconds": 0.0}
        found["motion"] = str(plan if plan.exists() else best)
        found["seconds"] = time.monotonic() - begin
        return found

    def replay(self, name, motion, robot=ROBOT, *options):
        """A replay's report; its run by time as NAME.series.csv."""
        return self.needed(name, "hopper", "replay", robot, motion, "--series",
                           self.folder / f"{name}.series.csv", *options)

    def trials_of(self, name, motion, document, robot=ROBOT, *options):
        """A report of randomised trials."""
        return self.needed(name, "hopper", "replay", robot, motion, "--trials", self.trials,
                           "--randomise", document, *options)

    def trial(self, name, number, motion, document, *options):
        """The run by time of one trial: its file."""
        path = self.folder / f"{name}.{number}.series.csv"
        self.run("hopper", "replay", ROBOT, motion, "--trials", self.trials, "--trial", number,
                 "--randomise", document, "--series", path, *options)
        return path

    def check(self, name, motion, robot=ROBOT, *options):
        """A check's report; everything by time as NAME.check.csv."""
        return self.answer(name, "hopper", "check", robot, motion, "--series",
                           self.folder / f"{name}.check.csv", *options)
