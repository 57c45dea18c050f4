# SPDX-License-Identifier: Apache-2.0
"""Copies of the hopper's documents in which something was changed."""
import copy
import json
import pathlib

SPECS = pathlib.Path("specs")


def load(path):
    return json.loads(pathlib.Path(path).read_text())


class Documents:
    """Robot, knee, ankle, gear strengths and randomisation, to be changed and written into a folder
    of their own."""

    def __init__(self):
        self.robot = load(SPECS / "robot/hopper.json")
        self.knee = load(SPECS / "actuator/d151_knee.json")
        self.ankle = load(SPECS / "actuator/d110a_ankle.json")
        self.strength = load(SPECS / "gearbox/d151_strength.json")
        self.gears = load(SPECS / "gearbox/d151_knee_result.json")

    def write(self, folder):
        """The robot's path."""
        folder = pathlib.Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        robot = copy.deepcopy(self.robot)
        knee, ankle = robot["mechanisms"]
        knee["actuators"] = ["knee.json"]
        if self.strength is not None:
            strength = copy.deepcopy(self.strength)
            strength["gearbox"] = {"file": "gears.json"}
            knee["transmission_limit"] = {"strength": "strength.json"}
            (folder / "strength.json").write_text(json.dumps(strength))
            (folder / "gears.json").write_text(json.dumps(self.gears))
        ankle["actuators"] = ["ankle.json", "ankle.json"]
        for name, document in (("robot", robot), ("knee", self.knee), ("ankle", self.ankle)):
            (folder / f"{name}.json").write_text(json.dumps(document))
        return str(folder / "robot.json")

    def drives(self):
        return (self.knee, self.ankle)


def with_knee_ratio(ratio):
    """What `hopper check --sweep knee_ratio=...` changes: the ratio, and the data sheet's torque at
    the joint. Limits of the gears stay at the motor's side."""
    documents = Documents()
    factor = ratio / documents.knee["gearbox"]["ratio"]
    documents.knee["gearbox"]["ratio"] = ratio
    sheet = documents.knee["datasheet"]
    sheet["peak_torque_Nm"] *= factor
    sheet["no_load_speed_rad_s"] /= factor
    for joint in documents.robot["joints"]:
        if joint["name"] == "knee":
            joint["torque_limit_Nm"] *= factor
            joint["speed_limit_rad_s"] /= factor
    return documents


def with_resistance(factor):
    documents = Documents()
    for drive in documents.drives():
        drive["motor"]["resistance_ohm"] *= factor
    return documents


def with_cell_voltage(cell_V):
    documents = Documents()
    documents.robot["battery"]["cell_open_circuit_V"] = cell_V
    return documents


def with_gear_friction(share):
    """Loaded teeth take that share of the load, driving and driven back."""
    documents = Documents()
    for drive in documents.drives():
        drive["effects"] = [{"effect": "load_dependent_friction", "parameters": {
            "driving_coefficient": share, "backdriving_coefficient": share}}]
    return documents


def with_thigh_inertia(inertia_kg_m2):
    documents = Documents()
    inertia = documents.robot["bodies"][0]["inertia_kg_m2"]
    inertia["xx"] = inertia["yy"] = inertia_kg_m2
    return documents


def quiet_randomisation(path):
    document = load(path)
    document.pop("sensor_noise")
    document["name"] += ", sensors without noise"
    return document


def known_randomisation(path):
    """Of a robot that was weighed and calibrated."""
    document = quiet_randomisation(path)
    document["name"] += ", masses measured"
    document["total_mass_factor"] = {"least": 0.98, "greatest": 1.02}
    document["body_inertia_factor"] = [{"least": 0.98, "greatest": 1.02}]
    document["center_of_mass_shift_m"][0].update(least=-0.003, greatest=0.003)
    document["controller_gain_factor"] = [{"least": 0.95, "greatest": 1.05}]
    return document
