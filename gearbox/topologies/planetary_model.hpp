// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "gearbox/problem.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox::planetary {

/// See Topology::model and Topology::free_teeth.
optimization::Problem model(const Problem& problem, std::int64_t planet_count,
                            const Rational& module_mm, std::int64_t ring_limit);
std::vector<std::int64_t> free_teeth(std::span<const std::int64_t> point);

}  // namespace torquewright::gearbox::planetary
