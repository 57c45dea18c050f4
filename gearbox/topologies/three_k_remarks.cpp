// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/topologies/three_k_design.hpp"
#include "gearbox/train/assembly.hpp"

namespace torquewright::gearbox::three_k {

namespace {

std::string clocking_list(const ThreeKDesign& design) {
  constexpr std::int64_t kMostListed = 12;
  std::string list;
  for (std::int64_t position = 0; position < std::min(design.planet_count, kMostListed);
       ++position) {
    list += fmt::format("{}{:.4g}", position == 0 ? "" : ", ",
                        planet_clocking_rad(design.teeth, design.planet_count, position));
  }
  return list + (design.planet_count > kMostListed ? ", ..." : "");
}

std::optional<Remark> efficiency_remark(const ThreeKDesign& design, const DesignReport& report) {
  for (const MeshReport& mesh : report.meshes) {
    if (mesh.efficiency <= 0.0) {
      return Remark{"efficiency",
                    fmt::format("efficiency: does not exist, no power passes the mesh {} "
                                "(contact ratio {:.4g}).",
                                mesh.name, mesh.contact_ratio)};
    }
  }
  if (design.stands_still()) {
    return Remark{"efficiency", "efficiency: does not exist, the output stands still."};
  }
  if (!design.problem.friction_coefficient) {
    return Remark{"efficiency",
                  "efficiency: no friction coefficient is given, so losses are left out."};
  }
  if (report.self_locking) {
    return Remark{"self_locking",
                  "self_locking: the output cannot drive the sun, whatever the load."};
  }
  return std::nullopt;
}

/// Does a remark say already that no gearbox can miss this?
bool is_noted(const std::vector<Remark>& list, const std::string& constraint) {
  return std::any_of(list.begin(), list.end(), [&](const Remark& remark) {
    return remark.sentence.starts_with("cannot_exist: " + constraint + ":");
  });
}

/// What the paper's own conditions let pass although it cannot be cut or assembled.
void append_unbuildable(const ThreeKDesign& design, std::vector<Remark>& list) {
  if (design.problem.constraints != ConstraintSet::kPaper) return;
  const std::vector<ConstraintReport> further = further_constraints(design);
  std::size_t met = 0;
  for (const ConstraintReport& constraint : further) {
    if (constraint.satisfied) {
      ++met;
    } else if (!is_noted(list, constraint.name)) {
      list.push_back({constraint.name, "not asked for: " + constraint.sentence});
    }
  }
  list.push_back({"buildable", fmt::format("buildable: of the {} further constraints of a "
                                           "buildable train, not asked for, {} hold.",
                                           further.size(),
                                           met == further.size() ? "all" : std::to_string(met))});
}

void append_if(std::optional<Remark> remark, std::vector<Remark>& list) {
  if (remark) list.push_back(*std::move(remark));
}

}  // namespace

std::vector<Remark> remarks(const ThreeKDesign& design, const DesignReport& report) {
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  std::vector<Remark> list = common_remarks(design.problem, report, teeth.sun, teeth.fixed_ring);
  append_if(efficiency_remark(design, report), list);
  if (report.planet_types > 1) {
    list.push_back(
        {"clocking",
         fmt::format("clocking: {} different planets; planet 2's teeth against planet 1's, "
                     "position by position [rad]: {}.",
                     report.planet_types, clocking_list(design))});
  }
  if (design.cut) {
    list.push_back(trimming_remark("planet_1_fixed_ring", design.cut->meshes[1].cut));
    list.push_back(trimming_remark("planet_2_output_ring", design.cut->meshes[2].cut));
  } else {
    list.push_back(trimming_remark("planet_1_fixed_ring", teeth.planet_1, teeth.fixed_ring));
    list.push_back(trimming_remark("planet_2_output_ring", teeth.planet_2, teeth.output_ring));
  }
  append_if(hunting_remark("sun_planet_1", teeth.sun, teeth.planet_1), list);
  append_if(hunting_remark("planet_1_fixed_ring", teeth.planet_1, teeth.fixed_ring), list);
  append_if(hunting_remark("planet_2_output_ring", teeth.planet_2, teeth.output_ring), list);
  append_unbuildable(design, list);
  return list;
}

}  // namespace torquewright::gearbox::three_k
