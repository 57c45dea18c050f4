// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/same_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace torquewright::identification {
namespace {

constexpr double kDisagreeingFactor = 2.0;
constexpr double kDisagreeingErrors = 6.0;
constexpr double kKnownWell = 0.25;  ///< Relative error, at most, of a value that is compared.

struct ValueOfRun {
  std::string run;
  double value;
  double error;
};

/// The value that a run alone asks for, everything else as fitted to all: one number, one equation.
std::optional<ValueOfRun> value_of_run(const Rows& rows, const ModelFit& fit,
                                       Eigen::Index parameter, const std::string& run,
                                       const std::vector<std::string>& name_of_run) {
  double top = 0.0, bottom = 0.0;
  std::vector<std::pair<double, double>> parts;
  for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
    if (name_of_run[rows.blocks()[b].run] != run) continue;
    const double slope = -fit.sums[b].descent[parameter];
    const double power = fit.sums[b].slopes(parameter, parameter);
    parts.emplace_back(slope, power);
    top += slope;
    bottom += power;
  }
  if (!(bottom > 0.0) || parts.size() < 3) return std::nullopt;
  const double change = top / bottom;
  double square = 0.0;
  for (const auto& [slope, power] : parts) {
    square += (slope - change * power) * (slope - change * power);
  }
  return ValueOfRun{run, fit.coordinates[parameter] + change, std::sqrt(square) / bottom};
}

bool disagree(const ValueOfRun& a, const ValueOfRun& b) {
  for (const ValueOfRun& each : {a, b}) {
    if (each.error > kKnownWell * std::abs(each.value)) return false;
  }
  const double low = std::min(std::abs(a.value), std::abs(b.value));
  const double high = std::max(std::abs(a.value), std::abs(b.value));
  return high > kDisagreeingFactor * low &&
         std::abs(a.value - b.value) > kDisagreeingErrors * std::hypot(a.error, b.error);
}

}  // namespace

std::string runs_that_disagree(const ForwardEquation& equation, const Rows& rows,
                               const ModelFit& fit, const std::vector<std::string>& name_of_run) {
  const std::set<std::string> names(name_of_run.begin(), name_of_run.end());
  for (std::size_t k = 0; k < equation.pointers.size(); ++k) {
    std::vector<ValueOfRun> values;
    for (const std::string& run : names) {
      const auto value = value_of_run(rows, fit, static_cast<Eigen::Index>(k), run, name_of_run);
      if (value) values.push_back(*value);
    }
    bool any = false;
    for (const ValueOfRun& a : values) {
      for (const ValueOfRun& b : values) any = any || disagree(a, b);
    }
    if (!any) continue;
    std::string list;
    for (const ValueOfRun& each : values) {
      list += fmt::format("{}{:.3g} in \"{}\"", list.empty() ? "" : ", ", each.value, each.run);
    }
    return fmt::format(
        "these runs are not of one rig: {} comes out as {}; identify runs that belong together",
        equation.pointers[k], list);
  }
  return "";
}

}  // namespace torquewright::identification
