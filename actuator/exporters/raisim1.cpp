// SPDX-License-Identifier: Apache-2.0
// RaiSim 1 limits torque by a box that may be set anew before every step:
// ArticulatedSystem::setActuationLimits(upper, lower), getActuationUpperLimits(),
// getActuationLowerLimits(), getGeneralizedVelocity() (raisimLib, header ArticulatedSystem.hpp at
// commit 9bcf414b, docs/sections/ArticulatedSystem.rst at 07188086; issues 53 and 244). The
// built-in PD controller is integrated implicitly and does not obey that box. N m, rad/s.
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
  Eigen::VectorXd upper = robot.getActuationUpperLimits().e();
  Eigen::VectorXd lower = robot.getActuationLowerLimits().e();
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
    .source =
        "https://github.com/raisimTech/raisimLib "
        "raisim/linux/include/raisim/object/ArticulatedSystem/ArticulatedSystem.hpp @ 9bcf414b",
    .advice =
        "Limits hold for a whole step at the speed of its start, and for torques that you command: "
        "RaiSim's own PD controller goes past them. Set the armature by "
        "<dynamics rotor_inertia=.../> in the URDF.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
