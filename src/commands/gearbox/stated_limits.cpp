// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/stated_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "io/faults/refusal.hpp"
#include "io/files/given_once.hpp"
#include "io/text/stepped_range.hpp"

namespace torquewright::cli {
namespace {

using gearbox::Dimension;
using gearbox::PartLimit;

constexpr double kMost_mm = 1.0;

struct Thickness {
  double least_mm = 0.0;
  double greatest_mm = 0.0;
};

/// "-0.06:-0.03"; `item` is what stands on the command line.
Thickness thickness_of(const std::string& item, const std::string& range) {
  const io::RangeRule rule{
      .refuse =
          [&item](const std::string&) {
            io::refuse("--tooth-thickness",
                       fmt::format("\"{}\": needs two lengths from -{:g} to {:g} mm, the lesser "
                                   "first, as in -0.06:-0.03",
                                   item, kMost_mm, kMost_mm));
          },
      .least = -kMost_mm,
      .greatest = kMost_mm};
  const std::size_t colon = range.find(':');
  const std::string second = colon == std::string::npos ? "" : range.substr(colon + 1);
  const Thickness limits{io::nearest(io::read_range_number(range.substr(0, colon), rule)),
                         io::nearest(io::read_range_number(second, rule))};
  if (limits.least_mm > limits.greatest_mm) rule.refuse("they descend");
  return limits;
}

void require_gear(const std::string& item, const std::string& gear,
                  const gearbox::CutTrain& train) {
  std::vector<std::string_view> names;
  for (const gearbox::CutGear& each : train.gears) names.push_back(each.name);
  if (std::find(names.begin(), names.end(), gear) != names.end()) return;
  io::refuse("--tooth-thickness", fmt::format("\"{}\" names no gear; {} has {}", item,
                                              train.train.topology, fmt::join(names, ", ")));
}

/// By gear; "" stands for all that are not named.
std::map<std::string, Thickness> stated_thickness(const StatedLimits& stated,
                                                  const gearbox::CutTrain& train) {
  io::require_each_once("--tooth-thickness", stated.tooth_thickness);
  std::map<std::string, Thickness> by_gear;
  for (const std::string& item : stated.tooth_thickness) {
    const std::size_t sign = item.find('=');
    const bool names_gear = sign != std::string::npos;
    const std::string gear = names_gear ? item.substr(0, sign) : "";
    if (names_gear) require_gear(item, gear, train);
    const Thickness thickness = thickness_of(item, names_gear ? item.substr(sign + 1) : item);
    if (!by_gear.emplace(gear, thickness).second) {
      io::refuse("--tooth-thickness", "has two limits for all gears");
    }
  }
  return by_gear;
}

void state(PartLimit& limit, double least, double greatest) {
  limit.least = least;
  limit.greatest = greatest;
  limit.is_assumed = false;
}

}  // namespace

void state_limits(const StatedLimits& stated, const gearbox::CutTrain& train,
                  std::vector<PartLimit>& limits) {
  const std::map<std::string, Thickness> thickness = stated_thickness(stated, train);
  for (PartLimit& limit : limits) {
    const gearbox::CutGear& gear = train.gears[limit.gear];
    switch (limit.dimension) {
      case Dimension::kCentreDistance:
        if (const auto& half_mm = stated.centre_distance_mm) state(limit, -*half_mm, *half_mm);
        break;
      case Dimension::kToothThickness: {
        auto found = thickness.find(std::string(gear.name));
        if (found == thickness.end()) found = thickness.find("");
        if (found != thickness.end())
          state(limit, found->second.least_mm, found->second.greatest_mm);
        break;
      }
      case Dimension::kProfileShift:
        if (const auto& half = stated.profile_shift) state(limit, -*half, *half);
        break;
      case Dimension::kTipDiameter:
        if (const auto& off_mm = stated.tip_diameter_mm) {
          state(limit, gear.internal ? 0.0 : -*off_mm, gear.internal ? *off_mm : 0.0);
        }
    }
  }
}

}  // namespace torquewright::cli
