// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/constraints/site.hpp"
#include "hopper/planning/plane/planned_motion.hpp"

namespace torquewright::hopper {

/// Returns by how much the ground's forces leave their planning margins within each interval of a
/// phase, the most of all samples (0: nowhere): the pressure point of a flat stance in shares of
/// the foot, friction in shares of the coefficient. Instants keep to them, and what lies between
/// follows by the method's order alone. Samples are at `times_s`, with what the ground gives each
/// contact point (`forces_N`, three rows a point).
std::vector<double> ground_excess(const Site& phase, const PlannedPhase& planned,
                                  const std::vector<double>& times_s,
                                  const Eigen::MatrixXd& forces_N);

}  // namespace torquewright::hopper
