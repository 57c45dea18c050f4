// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/region_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "actuator/motor/limiter_words.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

/// Told apart by the colour-blind as well (after Okabe and Ito's set).
const char* colour_of(Limiter limiter) {
  switch (limiter) {
    case Limiter::kCurrent:
      return "#0072b2";
    case Limiter::kVoltage:
      return "#d55e00";
    case Limiter::kFieldWeakening:
      return "#cc79a7";
    case Limiter::kRegeneration:
      return "#009e73";
    case Limiter::kBatteryPower:
      return "#b8a100";
    case Limiter::kGear:
      return "#555555";
    case Limiter::kThermal:
      return "#a00020";
    case Limiter::kEnvelope:
      return "#000000";
    case Limiter::kDemagnetisation:
      break;
  }
  return "#7030a0";
}

const JointBound& bound_of(const MorRow& row, bool is_upper) {
  return is_upper ? row.range.greatest : row.range.least;
}

std::string limited_by(Limiter limiter, bool has_battery) {
  return fmt::format("limited by {}", name_of(limiter, has_battery));
}

std::string point(const MorRow& row, bool is_upper) {
  return fmt::format("{:.9g},{:.9g}\n", row.speed_rad_s, bound_of(row, is_upper).torque_Nm);
}

}  // namespace

RegionLines::RegionLines(const MorTable& table, std::string name, bool has_battery)
    : name_(std::move(name)), has_battery_(has_battery) {
  for (const MorRow& row : table.rows) {
    if (row.range.is_empty) continue;
    outline_ += fmt::format("{:.9g},{:.9g},{:.9g}\n", row.speed_rad_s, row.range.least.torque_Nm,
                            row.range.greatest.torque_Nm);
  }
  add_bound(table, true);
  add_bound(table, false);
}

void RegionLines::add_bound(const MorTable& table, bool is_upper) {
  const MorRow* previous = nullptr;
  for (const MorRow& row : table.rows) {
    if (row.range.is_empty) {
      previous = nullptr;
      continue;
    }
    const Limiter limiter = bound_of(row, is_upper).limiter;
    const bool goes_on = previous != nullptr && bound_of(*previous, is_upper).limiter == limiter;
    if (!goes_on) {
      if (previous != nullptr) stretches_.back().points += point(row, is_upper);
      stretches_.push_back({limiter, ""});
    }
    stretches_.back().points += point(row, is_upper);
    previous = &row;
  }
}

std::string RegionLines::data() const {
  std::string text = fmt::format("${}_outline << END\n{}END\n", name_, outline_);
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    text += fmt::format("${}_{} << END\n{}END\n", name_, i, stretches_[i].points);
  }
  return text;
}

std::string RegionLines::shade(const char* colour) const {
  return fmt::format(
      "${}_outline using 1:2:3 with filledcurves fillcolor rgb '{}' notitle 'torques that are "
      "there'",
      name_, colour);
}

std::vector<std::string> RegionLines::plots(double width, std::size_t dash) const {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    plots.push_back(fmt::format(
        "${}_{} using 1:2 with lines linewidth {} dashtype {} linecolor rgb '{}' notitle {}", name_,
        i, width, dash, colour_of(stretches_[i].limiter),
        gnuplot_quoted(limited_by(stretches_[i].limiter, has_battery_))));
  }
  return plots;
}

std::string label_key(const std::string& label, double width, std::size_t dash) {
  return fmt::format("NaN with lines linewidth {} dashtype {} linecolor rgb '#333333' title {}",
                     width, dash, gnuplot_quoted(label));
}

std::vector<std::string> limiter_key(const std::vector<PlottedRegion>& regions) {
  std::set<std::pair<Limiter, bool>> limiters;
  for (const PlottedRegion& region : regions) {
    for (const MorRow& row : region.table.rows) {
      if (row.range.is_empty) continue;
      limiters.emplace(row.range.least.limiter, region.has_battery);
      limiters.emplace(row.range.greatest.limiter, region.has_battery);
    }
  }
  std::vector<std::string> plots;
  std::set<std::string> named;
  for (const auto& [limiter, has_battery] : limiters) {
    const std::string words = limited_by(limiter, has_battery);
    if (!named.insert(words).second) continue;
    plots.push_back(fmt::format("NaN with lines linewidth 3 linecolor rgb '{}' title {}",
                                colour_of(limiter), gnuplot_quoted(words)));
  }
  return plots;
}

}  // namespace torquewright::report
