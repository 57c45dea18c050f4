// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "gearbox/constraints/design_report.hpp"
#include "gearbox/problem.hpp"

namespace torquewright::hopper {

/// The proved answer to a gearbox problem at one ratio.
struct GearChoice {
  gearbox::Problem problem;  ///< With this ratio, and the face widths that were chosen.
  gearbox::DesignReport report;
  actuator::Transmission transmission;
  /// What no design beats that does as well in forward efficiency: of the problem's objective.
  double bound = 0.0;
};

enum class GearSearch {
  kProved,   ///< All that were asked for stand there, each proved.
  kNone,     ///< Proved that no design meets the problem at this ratio.
  kLimit,    ///< Ended before; what stands there is proved.
  kSkipped,  ///< Not searched: no motor could use it.
};

/// The gearboxes of one ratio, from the best by the problem's objective on.
struct GearsOfRatio {
  io::Rational ratio;
  GearSearch search = GearSearch::kSkipped;
  std::vector<GearChoice> choices;
};

/// The problem at another ratio, whose sign stays.
gearbox::Problem at_ratio(const gearbox::Problem& problem, const io::Rational& ratio);

/// Searches the problem at a ratio above 0: its optimum, or with more than one `points` the front
/// of its objective against forward efficiency. Requires a friction coefficient.
GearsOfRatio gears_of_ratio(const gearbox::Problem& problem, const io::Rational& ratio,
                            std::size_t points, const std::function<bool()>& should_stop);

}  // namespace torquewright::hopper
