// SPDX-License-Identifier: Apache-2.0
// Fields: JaxSim, src/jaxsim/rbda/actuation/common.py, ActuationParams (torque_max in N m, omega_th
// and omega_max in rad/s). Law: tn_curve_fn in src/jaxsim/api/actuation_model.py: torque_max up to
// omega_th, then linear to zero at omega_max, the same both ways.
#include <fmt/format.h>

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
    {"greatest_torque_Nm"}, {"knee_speed_rad_s"}, {"no_load_speed_rad_s"}};

Shape shape(const Subject& subject) {
  const Plateaus start = plateaus_of(subject);
  return fitted(subject, jaxsim, {start.drive_Nm, start.knee_rad_s, start.no_load_rad_s});
}

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const double width_rad_s = shape[2] - shape[1];
  if (!(width_rad_s > 0.0)) {  // the slope has no meaning
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, -kInfinity};
  }
  const double share = std::clamp((shape[2] - std::abs(speed_rad_s)) / width_rad_s, 0.0, 1.0);
  return {-share * shape[0], share * shape[0]};
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return line_comment(note, "# ") + fmt::format(R"(from jaxsim.rbda.actuation import ActuationParams

{} = ActuationParams(
    torque_max={},
    omega_th={},
    omega_max={},
)
)",
                                                identifier(subject.actuator.name), shape[0],
                                                shape[1], shape[2]);
}

}  // namespace

const Exporter jaxsim = {
    .name = "jaxsim",
    .simulator = "JaxSim, ActuationParams",
    .source = "https://github.com/ami-iit/jaxsim src/jaxsim/rbda/actuation/common.py @ e0e3286f",
    .advice =
        "One set for every joint of a model. The same for driving and braking, and applied to "
        "commanded torque and joint friction together. The armature goes into the joint's "
        "parameters of the model.",
    .parameters = kParameters,
    .derates_braking = true,
    .shape = shape,
    .law = law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
