// SPDX-License-Identifier: Apache-2.0
#include "identification/one_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/correction.hpp"

namespace torquewright::identification {
namespace {

constexpr double kDifferentFactor = 2.0;
constexpr double kDifferentErrors = 6.0;
constexpr double kWellKnown = 0.25;  ///< Relative error, at most, of a value that is compared.

struct RunValue {
  std::string run;
  double value;
  double error;
};

/// The value that a run alone asks for, everything else as fitted to all: one number, one equation.
std::optional<RunValue> value_in(const Fitter& fitter, const Fit& model, std::size_t coefficient,
                                 const Equation& equation, std::size_t run,
                                 const std::vector<std::size_t>& run_of_block,
                                 const std::string& name) {
  double top = 0.0, bottom = 0.0;
  std::vector<std::pair<double, double>> parts;
  for (std::size_t b = 0; b < run_of_block.size(); ++b) {
    if (run_of_block[b] != run) continue;
    const auto [slope, power] = fitter.slope(model, coefficient, b);
    parts.emplace_back(slope, power);
    top += slope;
    bottom += power;
  }
  if (!(bottom > 0.0) || parts.size() < 3) return std::nullopt;
  const double change = top / bottom;
  double square = 0.0;
  for (const auto& [slope, power] : parts)
    square += (slope - change * power) * (slope - change * power);
  const double fitted = model.values[static_cast<Eigen::Index>(coefficient)];
  const Correction own =
      corrected(equation, coefficient, fitted + change, std::sqrt(square) / bottom);
  return RunValue{name, own.value, own.standard_error};
}

bool differ(const RunValue& a, const RunValue& b) {
  for (const RunValue& each : {a, b}) {
    if (each.error > kWellKnown * std::abs(each.value)) return false;
  }
  const double low = std::min(std::abs(a.value), std::abs(b.value));
  const double high = std::max(std::abs(a.value), std::abs(b.value));
  return high > kDifferentFactor * low &&
         std::abs(a.value - b.value) > kDifferentErrors * std::hypot(a.error, b.error);
}

}  // namespace

std::string not_one_rig(const Fitter& fitter, const Fit& model, const Equation& equation,
                        const std::vector<std::size_t>& run_of_block,
                        const std::vector<std::string>& run_names) {
  for (std::size_t k = 0; k < equation.corrections.size(); ++k) {
    std::vector<RunValue> values;
    for (std::size_t run = 0; run < run_names.size(); ++run) {
      const auto value = value_in(fitter, model, k, equation, run, run_of_block, run_names[run]);
      if (value) values.push_back(*value);
    }
    bool any = false;
    for (const RunValue& a : values) {
      for (const RunValue& b : values) any = any || differ(a, b);
    }
    if (!any) continue;
    std::string list;
    for (const RunValue& each : values) {
      list += fmt::format("{}{} in \"{}\"", list.empty() ? "" : ", ",
                          fmt::format("{:.3g}", each.value), each.run);
    }
    return fmt::format(
        "these runs are not of one rig: {} comes out as {}; identify runs that belong together",
        equation.corrections[k].pointer, list);
  }
  return "";
}

}  // namespace torquewright::identification
