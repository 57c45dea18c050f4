// SPDX-License-Identifier: Apache-2.0
#include "identification/tight_spots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::identification {
namespace {

/// A harmonic over the mean: one is the limit of physics, the rest the fit's own error.
constexpr double kMostOverMean = 1.25;

bool is_dry_friction_of_many_levels(const std::string& effect) {
  return effect == "stribeck_friction" || effect == "asymmetric_friction" ||
         effect == "presliding_friction";
}

}  // namespace

bool are_tight_spots_possible(const Dictionary& dictionary, const std::vector<std::size_t>& members,
                              std::size_t first, const Eigen::VectorXd& values) {
  double mean_Nm = dictionary.stated_dry_friction_Nm, strongest_Nm = 0.0;
  auto at = static_cast<Eigen::Index>(first);
  for (const std::size_t member : members) {
    const Variant& variant = dictionary.variants[member];
    if (variant.effect == "coulomb_friction") mean_Nm += values[at];
    if (is_dry_friction_of_many_levels(variant.effect)) {
      mean_Nm = std::numeric_limits<double>::infinity();
    }
    if (variant.effect == "position_dependent_friction") {
      strongest_Nm = std::max(strongest_Nm, std::hypot(values[at], values[at + 1]));
    }
    at += static_cast<Eigen::Index>(variant.coefficients.size());
  }
  return strongest_Nm == 0.0 || strongest_Nm <= kMostOverMean * mean_Nm;
}

}  // namespace torquewright::identification
