// SPDX-License-Identifier: Apache-2.0
// Fields and law: unitree_rl_lab, UnitreeActuator(Cfg) and the README's figure; the same law in
// mjlab (UnitreeActuatorCfg), whose test gives the numbers ours is tested with. Effort is limited
// to Y1 where speed times effort is positive, else (also at rest) to Y2; from X1 on both fall
// linearly to zero at X2. rad/s, N m, kg m^2. Friction, off the clipped effort: Fs tanh(v / Va) +
// Fd v, Va 0.01 rad/s if not set (UnitreeActuator.compute in the same file).
#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/plateau_start.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr ShapeParameter kParameters[] = {
    {"knee_speed_rad_s"}, {"no_load_speed_rad_s"}, {"drive_torque_Nm"}, {"brake_torque_Nm"}};

Shape shape(const Subject& subject) {
  const Plateaus start = plateaus_of(subject);
  return fitted(subject, unitree_xy,
                {start.knee_rad_s, start.no_load_rad_s, start.drive_Nm, start.brake_Nm});
}

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const double knee_rad_s = shape[0];
  const double no_load_rad_s = shape[1];
  if (!(knee_rad_s < no_load_rad_s)) {  // the slope has no meaning
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, -kInfinity};
  }
  const double fall = (std::abs(speed_rad_s) - knee_rad_s) / (no_load_rad_s - knee_rad_s);
  const double share = std::clamp(1.0 - fall, 0.0, 1.0);
  const double drive_Nm = share * shape[2];
  const double brake_Nm = share * shape[3];
  return {speed_rad_s < 0.0 ? -drive_Nm : -brake_Nm, speed_rad_s > 0.0 ? drive_Nm : brake_Nm};
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  const PythonCall call{identifier(subject.actuator.name),
                        {{"joint_names_expr", "[\"joint\"]", true},
                         python_argument("X1", shape[0]),
                         python_argument("X2", shape[1]),
                         python_argument("Y1", shape[2]),
                         python_argument("Y2", shape[3]),
                         friction_argument("Fs", friction.coulomb_Nm),
                         friction_argument("Fd", friction.viscous_Nm_s_rad),
                         armature_argument(subject.armature_kg_m2()),
                         {"stiffness", "0.0", true},
                         {"damping", "0.0", true}}};
  return python_configurations(note, "unitree_rl_lab.assets.robots.unitree_actuators",
                               "UnitreeActuatorCfg", {&call, 1});
}

}  // namespace

const Exporter unitree_xy = {
    .name = "unitree-xy",
    .simulator = "Unitree RL Lab, UnitreeActuatorCfg",
    .source =
        "https://github.com/Milad-Rakhsha/unitree_rl_lab unitree_actuators.py @ b4430e63, a fork",
    .advice =
        "Braking falls with driving from X1 on and ends at X2, where a motor brakes fully. mjlab's "
        "names: X1 velocity_at_full_effort, X2 velocity_at_zero_effort, Y1 drive_effort_limit, Y2 "
        "brake_effort_limit, Fs static_friction, Fd dynamic_friction.",
    .parameters = kParameters,
    .derates_braking = true,
    .shape = shape,
    .law = law,
    .write = write,
    .friction =
        {DryFriction::kSmoothed,
         "Off the clipped effort it takes Fs tanh(v / Va) + Fd v (UnitreeActuator.compute): "
         "Fs is Coulomb's friction in Nm, Fd viscous in Nm s/rad, whatever their names; at "
         "rest it holds nothing. Va is 0.01 rad/s.",
         ""},
};

}  // namespace torquewright::actuator::exporters
