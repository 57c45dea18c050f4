// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Lab, docs/source/concepts/actuators.rst at commit 0120677c ("DCMotor":
// saturation_effort is the stall torque, actuator_velocity_limit the no-load speed; "Explicit
// groups keep the solver effort limit": joint_effort_limit at least actuator_effort_limit). Law:
// DCMotor._clip_effort in actuator_pd.py: the speed is clamped to +-w0 (1 + cap / stall) first, so
// that past it both limits are the cap against the motion. N m, rad/s, kg m^2. Friction: pull
// request 7412 (measured on both backends): friction and dynamic_friction are efforts in N m at the
// joint, viscous_friction is in N m s/rad. Isaac Lab 2: actuator_base_cfg.py of v2.3.2
// (effort_limit and velocity_limit are the actuator's, effort_limit_sim the solver's).
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, isaac_lab, line_start(subject)); }

/// What a version calls the actuator's limits and the solver's.
struct Names {
  std::string_view velocity;
  std::string_view effort;
  std::string_view solver_effort;
};
constexpr Names kOf3{"actuator_velocity_limit", "actuator_effort_limit", "joint_effort_limit"};
constexpr Names kOf2{"velocity_limit", "effort_limit", "effort_limit_sim"};

/// `joints`: expressions, behind commas; the user's where no joints are known.
std::vector<PythonArgument> arguments(const Names& names, const std::string& joints, bool is_yours,
                                      std::span<const double> shape, double armature_kg_m2,
                                      const JointFriction& friction) {
  const Parallelogram line = parallelogram_of(shape);
  return {{"joint_names_expr", "[" + joints + "]", is_yours},
          python_argument("saturation_effort", line.stall_torque_Nm),
          python_argument(names.velocity, line.no_load_speed_rad_s),
          python_argument(names.effort, line.greatest_torque_Nm),
          python_argument(names.solver_effort, line.greatest_torque_Nm),
          armature_argument(armature_kg_m2),
          friction_argument("friction", friction.breakaway_Nm),
          friction_argument("dynamic_friction", friction.coulomb_Nm),
          friction_argument("viscous_friction", friction.viscous_Nm_s_rad),
          {"stiffness", "0.0", true},
          {"damping", "0.0", true}};
}

template <const Names& names>
std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const PythonCall call{identifier(subject.actuator.name),
                        arguments(names, "\"joint\"", true, shape, subject.armature_kg_m2(),
                                  subject.friction.value_or(JointFriction{}))};
  return python_configurations(note, "isaaclab.actuators", "DCMotorCfg", {&call, 1});
}

template <const Names& names>
std::string write_all(std::span<const DriveEntry> entries, const std::vector<std::string>& note) {
  std::vector<PythonCall> calls;
  std::string listed;
  for (const DriveEntry& entry : entries) {
    calls.push_back(
        {entry.name, arguments(names, python_expressions(entry.joints), false, entry.shape,
                               entry.armature_kg_m2, entry.friction.value_or(JointFriction{}))});
    listed += fmt::format("    \"{0}\": {0},\n", entry.name);
  }
  return python_configurations(note, "isaaclab.actuators", "DCMotorCfg", calls) +
         "\n# ArticulationCfg(actuators=ACTUATORS)\nACTUATORS = {\n" + listed + "}\n";
}

}  // namespace

const Exporter isaac_lab = {
    .name = "isaac-lab",
    .simulator = "Isaac Lab 3, DCMotorCfg",
    .source = "https://github.com/isaac-sim/IsaacLab docs/source/concepts/actuators.rst @ 0120677c",
    .advice =
        "For the fields of Isaac Lab 2: isaac-lab-2.3. Before pull request 2300 (April 2025) "
        "braking past the no-load speed was forced to zero.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write<kOf3>,
    .write_all = write_all<kOf3>,
    .friction =
        {DryFriction::kBreakaway,
         "friction is the effort at rest, dynamic_friction that in motion, viscous_friction "
         "per speed, all at the joint (docs/source/concepts/actuators.rst @ 0120677c, "
         "Friction; pull request 7412). Newton has one dry friction, friction. OVPhysX, and "
         "Isaac Sim before 5.0, take both for coefficients, which these are not.",
         ""},
};

const Exporter isaac_lab_2_3 = {
    .name = "isaac-lab-2.3",
    .simulator = "Isaac Lab 2.3, DCMotorCfg",
    .source =
        "https://github.com/isaac-sim/IsaacLab source/isaaclab/isaaclab/actuators/"
        "actuator_base_cfg.py of v2.3.2",
    .advice = "Isaac Lab 3 calls these fields otherwise: isaac-lab.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write<kOf2>,
    .write_all = write_all<kOf2>,
    .friction =
        {DryFriction::kBreakaway,
         "friction is the effort at rest, dynamic_friction that in motion, viscous_friction per "
         "speed, all at the joint, with Isaac Sim 5; with 4.5 they are coefficients, which these "
         "are not (actuator_base_cfg.py of v2.3.2).",
         ""},
};

}  // namespace torquewright::actuator::exporters
