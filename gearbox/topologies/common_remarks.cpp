// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gearbox/constraints/existence.hpp"
#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {

namespace {

const char* phasing_text(Phasing value) {
  switch (value) {
    case Phasing::kInPhase:
      return "all planets mesh in phase: torque ripple, no sideways force on the rings";
    case Phasing::kSequential:
      return "the planets mesh one after the other: little torque ripple, a rotating sideways "
             "force";
    case Phasing::kCounter:
      return "the planets mesh in counter phase: torque and sideways forces cancel";
  }
  return "";
}

/// What the problem's constraints leave open and no gearbox can do without.
std::vector<Remark> existence_remarks(const Problem& problem, const DesignReport& report) {
  std::vector<Remark> list;
  for (const ConstraintReport& violated : what_cannot_exist(gear_train(problem, report.design))) {
    const bool is_constraint =
        std::any_of(report.constraints.begin(), report.constraints.end(),
                    [&](const ConstraintReport& each) { return each.name == violated.name; });
    if (!is_constraint) list.push_back({"cannot_exist", "cannot_exist: " + violated.sentence});
  }
  return list;
}

}  // namespace

Remark phasing_remark(const std::string& ring_name, std::int64_t ring, std::int64_t planet_count) {
  return {"phasing." + ring_name,
          fmt::format("phasing.{}: {} teeth and {} planets: {}.", ring_name, ring, planet_count,
                      phasing_text(phasing(ring, planet_count)))};
}

std::vector<Remark> common_remarks(const Problem& problem, const DesignReport& report,
                                   std::int64_t sun, std::int64_t held_ring) {
  std::vector<Remark> list = existence_remarks(problem, report);
  list.push_back(
      {"ring_blank",
       fmt::format("ring_blank: the largest ring needs a blank of {:.4g} mm, {}.",
                   report.ring_blank_diameter_mm,
                   problem.constraints == ConstraintSet::kPaper
                       ? "which the paper's constraints do not ask for"
                       : fmt::format("{:.4g} mm are there", io::nearest(ring_space_mm(problem))))});
  const auto cut = cut_train(gear_train(problem, report.design));
  if (problem.constraints == ConstraintSet::kBuildable && cut) {
    const std::vector<GearCutter> cutters = gear_cutters(*cut);
    const double clearance = std::min(cutters.front().addendum, cutters.back().addendum) - 1.0;
    list.push_back(
        {"cutters",
         fmt::format("cutters: {}; so that every tip stays at least {:.4g} mm "
                     "away from the root circle of its mate.",
                     cutter_sentence(cutters), clearance * io::nearest(report.design.module_mm))});
  }
  if (report.hollow_shaft_diameter_mm <= 0.0) {
    list.push_back({"hollow_shaft", "hollow_shaft: no hollow shaft fits through this sun."});
  }
  if (spacing_remainder(sun, held_ring, report.design.planet_count) == 0) {
    for (const GearReport& gear : report.gears) {
      if (!gear.internal) continue;
      list.push_back(phasing_remark(gear.name, gear.teeth, report.design.planet_count));
    }
  }
  list.push_back(
      {"planet_positions",
       fmt::format("planet_positions: planets can stand at whole multiples of {:.4g} rad, "
                   "equally spaced or not.",
                   spacing_unit_rad(sun, held_ring))});
  return list;
}

Remark trimming_remark(const std::string& mesh, std::int64_t planet, std::int64_t ring) {
  const CutPair cut{{MeshKind::kInternal, static_cast<double>(planet), static_cast<double>(ring)},
                    kReferenceAngle_rad,
                    static_cast<double>(planet) + 2.0,
                    static_cast<double>(ring) - 2.0};
  return trimming_remark(mesh, ring > planet ? std::optional(cut) : std::nullopt);
}

Remark trimming_remark(const std::string& mesh, const std::optional<CutPair>& cut) {
  const std::optional<double> margin = cut ? trimming_margin(*cut) : std::nullopt;
  const std::string name = "trimming." + mesh;
  if (!margin || *margin < 0.0) {
    return {name, name + ": this planet goes into its ring along the axis only."};
  }
  return {name,
          fmt::format("{}: this planet can be pushed into its ring radially, {:.3g} rad to spare.",
                      name, *margin)};
}

std::optional<Remark> hunting_remark(const std::string& mesh, std::int64_t teeth_1,
                                     std::int64_t teeth_2) {
  if (is_hunting(teeth_1, teeth_2)) return std::nullopt;
  const std::string name = "hunting_tooth." + mesh;
  return Remark{name,
                fmt::format("{}: {} and {} teeth share the divisor {}, so the same teeth keep "
                            "meeting and wear does not even out.",
                            name, teeth_1, teeth_2, std::gcd(teeth_1, teeth_2))};
}

}  // namespace torquewright::gearbox
