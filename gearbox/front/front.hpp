// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// A design with the best first quantity among all that do as well in the second.
struct FrontPoint {
  double first = 0.0;
  double first_bound = 0.0;  ///< What no design that does as well in the second beats.
  double second = 0.0;
  /// Whoever asks for something between this and `second` gets this design, within the first's
  /// bound; absent: whoever asks for less, too.
  std::optional<double> from = {};
  Problem problem;  ///< With the face widths that were chosen.
  DesignReport report;
};

/// What the best of one quantity costs of another, from the best first to the best second.
struct Front {
  std::vector<FrontPoint> points;
  /// Proved: no design does as well as that in the second, or better.
  std::optional<double> none_from = {};
  bool is_whole = false;  ///< No limit ended it.
};

struct FrontOptions {
  std::size_t points = 8;  ///< Where shifts are chosen: how many at least, if there are two.
  std::function<bool()> should_stop = [] { return false; };
  std::function<void(std::size_t points)> report = [](std::size_t) {};
};

/// The value of an objective as the user reads it; nothing where its keys are missing.
std::optional<double> objective_value(Objective objective, const DesignReport& report);
/// Whether more of it is better.
bool is_greater_better(Objective objective);
/// What a synthesis can be asked for at least, or at most.
bool can_be_limited(Objective objective);

/// The front of the problem's objective against another, by epsilon constraints: each point is the
/// proved answer to the problem that asks for so much of the second. Of whole numbers every point
/// there is; with `synthesis` (mass against what can_be_limited()) points that share the range
/// evenly.
Front design_front(const Problem& problem, Objective second, const FrontOptions& options);

}  // namespace torquewright::gearbox
