# SPDX-License-Identifier: Apache-2.0
"""Files that hold tables and are no text are read (gzip, NumPy archives), or refused with the line
that makes a CSV file of them. Oracle: the programs that write such files, the answer on the same
table as text, and the line itself, which is run as it stands."""

import gzip
import lzma
import os
import pickle
import re
import sqlite3
import subprocess
import sys
import tempfile
import unittest
import zipfile

import numpy as np

import program

COLUMNS = {
    "time_s": [0.0, 0.01, 0.02],
    "knee_position_rad": [0.0, 0.01, 0.03],
    "knee_velocity_rad_s": [1.0, 1.5, 2.0],
    "knee_torque_Nm": [5.0, 6.0, 7.0],
}


class ForeignFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def check(self, file):
        return subprocess.run(
            [os.environ["TORQUEWRIGHT_PROGRAM"], "actuator", "check", file,
             "--joint", "knee=" + program.KNEE], capture_output=True, text=True)

    def sentence(self, file, kind):
        done = self.check(file)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("is not CSV but " + kind, done.stderr)
        return done.stderr

    def run_line_of(self, sentence, file):
        """The sentence's line of Python, on the file; the table that it writes is read."""
        line = re.search(r'python3 -c "(.*)"', sentence).group(1).replace("FILE", file)
        subprocess.run([sys.executable, "-c", line], check=True)
        done = self.check(file + ".csv")
        self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_packed_motions_are_checked_as_text_is(self):
        text = "\n".join(",".join(map(str, row)) for row in [COLUMNS, *zip(*COLUMNS.values())])
        with open(self.path("motion.csv"), "w") as out:
            out.write(text)
        with gzip.open(self.path("motion.csv.gz"), "wt") as out:
            out.write(text)
        np.savez_compressed(self.path("motion.npz"), **COLUMNS)
        answer = self.check(self.path("motion.csv"))
        self.assertIn(answer.returncode, (0, 1), answer.stderr)
        for packed in ["motion.csv.gz", "motion.npz"]:
            self.assertEqual(
                self.check(self.path(packed)).stdout.replace(packed, "motion.csv"), answer.stdout)

    def test_tables_of_pandas_become_tables(self):
        file = self.path("log.pkl")
        with open(file, "wb") as out:
            pickle.dump(COLUMNS, out)
        sentence = self.sentence(file, "a Python pickle")
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("python3-pandas is not installed: the line of pickles is not run")
        self.run_line_of(sentence, file)

    def test_every_other_format_is_known_by_what_writes_it(self):
        np.save(self.path("a.npy"), np.zeros(3))
        with lzma.open(self.path("a.csv.xz"), "wt") as out:
            out.write("time_s\n0\n")
        with zipfile.ZipFile(self.path("a.zip"), "w") as out:
            out.writestr("log.csv", "time_s\n0\n")
        with zipfile.ZipFile(self.path("a.xlsx"), "w") as out:
            out.writestr("[Content_Types].xml", "<Types/>")
        database = sqlite3.connect(self.path("a.db3"))
        database.execute("CREATE TABLE messages (data BLOB)")
        database.commit()
        database.close()
        for name, kind in [("a.npy", "a NumPy array"), ("a.csv.xz", "compressed by xz"),
                           ("a.zip", "a zip archive"), ("a.xlsx", "a spreadsheet's own file"),
                           ("a.db3", "a database")]:
            self.sentence(self.path(name), kind)

    def test_text_is_none_of_them(self):
        for name in ["PKs", "PAR1", "SQL"]:
            file = self.path(name + ".csv")
            with open(file, "w") as out:
                out.write(name + ",time_s\n1,0\n")
            self.assertNotIn("is no text", self.check(file).stderr)


if __name__ == "__main__":
    unittest.main()
