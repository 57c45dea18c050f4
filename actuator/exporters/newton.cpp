// SPDX-License-Identifier: Apache-2.0
// Fields and law: Newton, newton/_src/actuators/clamping/clamping_dc_motor.py as of commit
// 80c0da73a (23 April 2026): with v first clamped to +-velocity_limit (1 + max_motor_effort /
// saturation_effort),
//   effort_max(v) = min(saturation_effort (1 - v / velocity_limit), max_motor_effort)
//   effort_min(v) = max(saturation_effort (-1 - v / velocity_limit), -max_motor_effort)
// The builder's call is the one in Newton's own tests. Degrees of freedom and coordinates are
// counted apart: a floating base has six of the one and seven of the other. N m, rad/s, kg m^2.
// Friction: Model.joint_friction (N m) and Model.joint_damping (N m s/rad, "always active on the
// joint"), which SolverMuJoCo hands on as dof_frictionloss and dof_damping
// (update_dof_properties_kernel in newton/_src/solvers/mujoco/kernels.py).
#include <fmt/format.h>

#include <algorithm>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, newton, line_start(subject)); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const Parallelogram line = parallelogram_of(shape);
  const double corner = 1.0 + line.greatest_torque_Nm / line.stall_torque_Nm;
  const double share = std::clamp(speed_rad_s / line.no_load_speed_rad_s, -corner, corner);
  return {std::max(line.stall_torque_Nm * (-1.0 - share), -line.greatest_torque_Nm),
          std::min(line.stall_torque_Nm * (1.0 - share), line.greatest_torque_Nm)};
}

std::string armature_line(double armature_kg_m2) {
  if (armature_kg_m2 == 0.0) return "";
  return fmt::format("    builder.joint_armature[dof] = {}\n", armature_kg_m2);
}

std::string friction_lines(const std::optional<JointFriction>& friction) {
  if (!friction) return "";
  return fmt::format("    builder.joint_friction[dof] = {}\n    builder.joint_damping[dof] = {}\n",
                     friction->coulomb_Nm, friction->viscous_Nm_s_rad);
}

constexpr const char* kImports = "from newton.actuators import ClampingDCMotor, ControllerPD\n";

/// The function that adds one drive.
std::string function_text(const std::string& name, std::span<const double> shape,
                          double armature_kg_m2, const std::optional<JointFriction>& friction) {
  const Parallelogram line = parallelogram_of(shape);
  return fmt::format(R"(

def add_{0}(builder, joint, kp=0.0, kd=0.0, strength=1.0):
    """Adds the actuator to a newton.ModelBuilder, at the index of a joint of one degree of freedom.

    strength: a factor on the torque that the motor makes within its law.
    """
    dof = builder.joint_qd_start[joint]
    builder.add_actuator(
        ControllerPD,
        index=dof,
        pos_index=builder.joint_q_start[joint],
        kp=strength * kp,
        kd=strength * kd,
        clamping=[
            (
                ClampingDCMotor,
                {{
                    "saturation_effort": strength * {1},
                    "velocity_limit": {2},
                    "max_motor_effort": strength * {3},
                }},
            )
        ],
    )
{4}{5})",
                     name, line.stall_torque_Nm, line.no_load_speed_rad_s, line.greatest_torque_Nm,
                     armature_line(armature_kg_m2), friction_lines(friction));
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return line_comment(note, "# ") + kImports +
         function_text(identifier(subject.actuator.name), shape, subject.armature_kg_m2(),
                       subject.friction);
}

std::string write_all(std::span<const DriveEntry> entries, const std::vector<std::string>& note) {
  std::string text = line_comment(note, "# ") + kImports;
  std::string table;
  for (const DriveEntry& entry : entries) {
    text += function_text(entry.name, entry.shape, entry.armature_kg_m2, entry.friction);
    for (const std::string& joint : entry.joints) {
      table += fmt::format("    {}: add_{},\n", python_string(joint), entry.name);
    }
  }
  return text + fmt::format(R"(

ACTUATORS = {{
{}}}


def add_actuators(builder, joints, kp=0.0, kd=0.0, strength=None):
    """Adds every actuator to a newton.ModelBuilder; `joints` are indices by names of joints.

    strength: factors by name on what the motors make, 1 where there is none.
    """
    for name, add in ACTUATORS.items():
        add(builder, joints[name], kp, kd, (strength or {{}}).get(name, 1.0))
)",
                            table);
}

}  // namespace

const Exporter newton = {
    .name = "newton",
    .simulator = "Newton, ClampingDCMotor",
    .source =
        "https://github.com/newton-physics/newton "
        "newton/_src/actuators/clamping/clamping_dc_motor.py @ 80c0da73a",
    .advice =
        "Newton of before that commit (23 April 2026) does not clamp the speed: past the overspeed "
        "its limits cross.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .write_all = write_all,
    .friction =
        {DryFriction::kOneValue,
         "joint_friction is Coulomb's at rest and in motion, joint_damping is always active "
         "(Model's documentation); both are the builder's, and a solver may leave one out: "
         "SolverMuJoCo has both.",
         ""},
};

}  // namespace torquewright::actuator::exporters
