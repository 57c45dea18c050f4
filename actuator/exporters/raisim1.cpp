// SPDX-License-Identifier: Apache-2.0
// RaiSim 1 limits torque by a box that may be set anew before every step:
// ArticulatedSystem::setActuationLimits(upper, lower), getUpperLimitForce(), getLowerLimitForce(),
// getGeneralizedVelocity() (raisim.com, ArticulatedSystem; raisimLib issues 53 and 244). N m,
// rad/s.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const std::string name = identifier(subject.actuator.name);
  return line_comment(note, "// ") + fmt::format(R"(#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <raisim/World.hpp>
#include <utility>

{0}
/// Call before every World::integrate(). `dof` counts as in the generalized velocity.
inline void limit_{1}(raisim::ArticulatedSystem& robot, int dof) {{
  Eigen::VectorXd upper = robot.getUpperLimitForce().e();
  Eigen::VectorXd lower = robot.getLowerLimitForce().e();
  const auto [least, greatest] = {1}_torque_limits(robot.getGeneralizedVelocity().e()[dof]);
  upper[dof] = greatest;
  lower[dof] = least;
  robot.setActuationLimits(upper, lower);
}}
)",
                                                 table_function(name + "_torque_limits", shape),
                                                 name);
}

}  // namespace

const Exporter raisim1 = {
    .name = "raisim1",
    .simulator = "RaiSim 1, C++ callback",
    .source = "https://raisim.com ArticulatedSystem::setActuationLimits; raisimLib issues 53, 244",
    .advice =
        "Limits hold for a whole step at the speed of its start. Set the armature by "
        "<dynamics rotor_inertia=.../> in the URDF.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
