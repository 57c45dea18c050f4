// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/strength_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {
namespace {

/// Two walls of one tooth height, in modules (docs/decisions/0004).
constexpr double kWalls = 2.0 * 2.25;

std::vector<StrengthCase> over_widths(const StrengthCase& strength,
                                      const std::vector<double>& widths_mm) {
  if (widths_mm.empty()) return {strength};
  std::vector<StrengthCase> cases;
  for (const double width_mm : widths_mm) {
    cases.push_back(strength);
    for (double& own_mm : cases.back().train.face_width_mm) own_mm = width_mm;
  }
  return cases;
}

/// Why gears of this size are none of this gearbox: the largest ring's root circle alone is as
/// large as the room. Empty: they may be, or no room is stated.
std::string blank_objection(const GearTrain& train, double ring_space_mm) {
  if (!(ring_space_mm > 0.0)) return "";
  const TrainParts& parts = train_parts(train.topology);
  double root_mm = 0.0;
  for (std::size_t i = 0; i < parts.gears.size(); ++i) {
    if (!parts.is_ring(i)) continue;
    const double shift = i < train.shifts.size() ? train.shifts[i] : 0.0;
    const double teeth = static_cast<double>(train.teeth[i]) + 2.0 * shift;
    root_mm = std::max(root_mm, train.module_of_layer_mm(parts.gear_layers[i]) *
                                    (teeth + 2.0 * train.cutters.shaper_depth()));
  }
  if (root_mm < ring_space_mm) return "";
  return fmt::format(
      "module {} mm: with the teeth {} the roots of a ring lie on {:.4g} mm, which does not fit "
      "into {} mm",
      train.module_mm, fmt::join(train.teeth, "/"), root_mm, ring_space_mm);
}

}  // namespace

std::vector<std::int64_t> stage_with_most_teeth(const GearTrain& stage, double module_mm,
                                                double ring_space_mm) {
  GearTrain tried = stage;
  tried.module_mm = module_mm;
  tried.shifts.assign(stage.teeth.size(), 0.0);
  const double blank_teeth =
      ring_space_mm / module_mm - 2.0 * stage.cutters.shaper_depth() - kWalls;
  const auto most = static_cast<std::int64_t>(std::floor(blank_teeth + 1e-9));
  const Topology& topology = *find_topology(stage.topology);
  tried.teeth = topology.largest_of_same_ratio(stage.teeth, most);
  while (!tried.teeth.empty() && !objections(tried).empty()) {
    tried.teeth = topology.largest_of_same_ratio(stage.teeth, tried.teeth[topology.held_ring] - 1);
  }
  return tried.teeth;
}

StrengthVariants strength_variants(const StrengthCase& strength,
                                   const std::vector<double>& modules_mm,
                                   const std::vector<double>& face_widths_mm,
                                   double ring_space_mm) {
  StrengthVariants variants;
  const auto add = [&](const StrengthCase& sized) {
    for (StrengthCase& each : over_widths(sized, face_widths_mm)) {
      variants.cases.push_back(std::move(each));
    }
  };
  if (modules_mm.empty()) add(strength);
  for (const double module_mm : modules_mm) {
    StrengthCase sized = strength;
    sized.train.module_mm = module_mm;
    if (find_topology(strength.train.topology)->largest_of_same_ratio != nullptr) {
      sized.train.teeth = stage_with_most_teeth(strength.train, module_mm, ring_space_mm);
      sized.train.shifts.assign(strength.train.teeth.size(), 0.0);
      if (sized.train.teeth.empty()) {
        variants.left_out.push_back(
            fmt::format("module {} mm: no teeth of that ratio without undercut fit a ring of {} mm",
                        module_mm, ring_space_mm));
        continue;
      }
    }
    const std::string too_large = blank_objection(sized.train, ring_space_mm);
    if (!too_large.empty()) {
      variants.left_out.push_back(too_large);
      continue;
    }
    add(sized);
  }
  return variants;
}

}  // namespace torquewright::gearbox
