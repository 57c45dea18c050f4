// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "gearbox/problem.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox::planetary {

/// See Topology: model, free_teeth, point_of.
optimization::Problem model(const Problem& problem, std::int64_t planet_count,
                            const Rational& module_mm, std::int64_t ring_limit);
std::vector<std::int64_t> free_teeth(std::span<const std::int64_t> point);
std::vector<std::int64_t> point_of(std::span<const std::int64_t> free_teeth);

}  // namespace torquewright::gearbox::planetary
