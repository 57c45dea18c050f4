# SPDX-License-Identifier: Apache-2.0
"""The built program, run as a user runs it: the oracle of what Python answers."""

import importlib.util
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["TORQUEWRIGHT_PROGRAM"]
os.chdir(ROOT)  # examples are named as pages name them

KNEE = "specs/actuator/d151_knee.json"
LOSSY = "specs/actuator/ak80_9.json"


def rubbing_knee(folder):
    """A file of the knee with friction, whose bounds jump at rest."""
    document = json.loads((ROOT / KNEE).read_text())
    friction = {"coulomb_Nm": 6.0}
    document["effects"] = [
        {"effect": "coulomb_friction", "parameters": friction, "provenance": "assumed"}
    ]
    document["gearbox"].update(forward_efficiency=0.9, backward_efficiency=0.85)
    file = pathlib.Path(folder) / "rubbing_knee.json"
    file.write_text(json.dumps(document))
    return str(file)


def run(*words):
    """Exit code, stdout and stderr."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=ROOT, check=False)
    return done.returncode, done.stdout, done.stderr


def printed(*words):
    """What the program prints with --json, as a dictionary."""
    code, out, err = run(*words, "--json")
    assert code in (0, 1, 3), err
    return json.loads(out)


def exported_module(*words):
    """The module of `actuator mor --format python` whose limits are the joint's, loaded."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "exported.py"
        code, _, err = run("actuator", "mor", *words, "--format", "python", "--friction", "limits",
                           "-o", str(file))
        assert code == 0, err
        spec = importlib.util.spec_from_file_location("exported", file)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module
