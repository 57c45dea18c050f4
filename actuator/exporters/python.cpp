// SPDX-License-Identifier: Apache-2.0
// One Python module that needs nothing but the array library of whoever calls it: the region itself
// as tables, and actuators of Isaac Lab, of Newton and of mjlab made of it. N m, rad/s, V, K, kg
// m^2.
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/source_text/python_classes.hpp"
#include "actuator/source_text/python_newton.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const bool has_friction = subject.friction.has_value();
  return python_module(
      subject, shape, note,
      {.methods = python_configurations_of(has_friction) + python_newton(has_friction),
       .functions = python_classes(has_friction),
       .composes_friction = true});
}

}  // namespace

const Exporter python = {
    .name = "python",
    .simulator = "Python, a module for NumPy, PyTorch and JAX (Isaac Lab, mjlab)",
    .source =
        "https://data-apis.org/array-api; IsaacLab actuators/actuator_pd.py @ eafe554d; mjlab "
        "actuator/actuator.py and pd_actuator.py @ 018e7ee3",
    .advice =
        "The region itself: clip(torque, velocity, voltage, temperature) of arrays. Isaac Lab: "
        "REGION.isaac_lab(joint_names_expr=[...], stiffness=..., damping=...); mjlab: "
        "REGION.mjlab(target_names_expr=(...), stiffness=..., damping=...). A command is the "
        "torque on the load: what friction takes is in the limits, not subtracted besides.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
    .friction =
        {DryFriction::kComposed,
         "torque(command, velocity) is the drive's law: the command clipped as the motor is, "
         "less friction, through the gear, which loses in proportion to load driving and "
         "braking. Dry friction turns over with tanh(velocity / smoothing_rad_s) and holds "
         "nothing at rest; what turns on the angle is left out.",
         "clip(torque, velocity, voltage, temperature) of arrays are the motor's limits, "
         "torque(command, ...) what reaches the joint. Isaac Lab: "
         "REGION.isaac_lab(joint_names_expr=[...], stiffness=..., damping=...); mjlab: "
         "REGION.mjlab(target_names_expr=(...), stiffness=..., damping=...): both call "
         "torque(). Isaac Lab 3 runs explicit actuators of its own classes natively by default and "
         "refuses others: for that REGION.isaac_lab_native(...), which Newton reads as this "
         "region; "
         "isaac_lab(...) for SimulationCfg(use_newton_actuators=False) "
         "(concepts/actuators.rst @ 0120677c, pull request 7713). Explicit friction needs a "
         "step shorter than the joint's inertia times "
         "smoothing_rad_s over the dry torque: make smoothing_rad_s larger where it is not."},
};

}  // namespace torquewright::actuator::exporters
