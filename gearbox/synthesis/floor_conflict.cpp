// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/floor_conflict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <string>
#include <utility>

#include "gearbox/any_topology.hpp"
#include "gearbox/floors.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {
namespace {

SynthesisResult any_design(const Problem& problem, const SynthesisOptions& options) {
  SynthesisOptions asked = options;
  asked.any = true;
  return synthesise(problem, asked);
}

/// Something that a problem asks and that can be left out.
struct Demand {
  std::string name;
  std::string phrase;  ///< Of what is left out: "min_backward_efficiency".
  std::function<void(Problem&)> leave_out;
  /// What a design found without it has, beside what is asked for.
  std::function<std::string(const SizedDesign&)> had;
};

/// "mass 0.21 where at most 0.2 kg is asked for".
std::string what_it_has(const FloorRecord& floor, const Problem& problem,
                        const SizedDesign& sized) {
  Problem asked = sized.problem;
  asked.floors = {};
  asked.floors.*floor.limit = problem.floors.*floor.limit;
  const auto report = find_topology(sized.problem.topology)->evaluate(asked, sized.design);
  for (const ConstraintReport& constraint : report.constraints) {
    if (constraint.name != floor.name) continue;
    return fmt::format("{} {:.4g} where {} {:.6g}{} is asked for", floor.name, constraint.value,
                       floor.is_ceiling ? "at most" : "at least", constraint.limit,
                       floor.unit == "1" ? "" : " " + std::string(floor.unit));
  }
  return std::string(floor.name);
}

Demand face_widths() {
  return {"face_width", "limits of face widths",
          [](Problem& each) {
            SynthesisRequest& request = *each.synthesis;
            request.greatest_face_width_mm.reset();
            request.greatest_face_width_over_module.reset();
            request.greatest_face_width_over_diameter.reset();
          },
          [](const SizedDesign& sized) {
            const auto& [first, second] = sized.face_width_mm;
            return fmt::format("face widths of {:.4g}{} mm", first,
                               second > 0.0 ? fmt::format(" and {:.4g}", second) : "");
          }};
}

Demand torque_borne() {
  return {"torque_borne", "min_torque_borne_Nm",
          [](Problem& each) { each.floors.torque_borne_Nm.reset(); },
          [](const SizedDesign& sized) {
            return fmt::format("its teeth bear {:.4g} Nm", sized.borne.joint_Nm);
          }};
}

Demand stiffness() {
  return {"stiffness", "min_stiffness_Nm_rad",
          [](Problem& each) { each.floors.stiffness_Nm_rad.reset(); },
          [](const SizedDesign& sized) {
            return fmt::format("its teeth have {:.4g} Nm/rad", sized.stiffness_Nm_rad);
          }};
}

Demand load() {
  return {"load", "load",
          [](Problem& each) { each.load_output_torque_Nm = Rational(1, 1'000'000); },
          [](const SizedDesign&) { return std::string("its teeth bear next to nothing"); }};
}

/// The load first: where it has no part, searches without it end soon.
std::vector<Demand> all_demands(const Problem& problem) {
  std::vector<Demand> list{load(), face_widths()};
  for (const FloorRecord& floor : kFloors) {
    if (!(problem.floors.*floor.limit)) continue;
    list.push_back({std::string(floor.name), std::string(floor.key.substr(1)),
                    [&floor](Problem& each) { (each.floors.*floor.limit).reset(); },
                    [&](const SizedDesign& sized) { return what_it_has(floor, problem, sized); }});
  }
  if (problem.floors.torque_borne_Nm) list.push_back(torque_borne());
  if (problem.floors.stiffness_Nm_rad) list.push_back(stiffness());
  return list;
}

ConflictMember member(const Demand& demand, const SizedDesign& sized, bool is_open) {
  return {
      demand.name, sized.design,
      fmt::format("Without {} there is {}{} with {} planets, of {:.4g} kg: {}.", demand.phrase,
                  is_open ? sized.problem.topology + " " : "", fmt::join(sized.design.teeth, "/"),
                  sized.design.planet_count, sized.mass_kg, demand.had(sized)),
      is_open ? sized.problem.topology : ""};
}

}  // namespace

std::vector<std::string> demands_of(const Problem& problem) {
  std::vector<std::string> names;
  for (const Demand& demand : all_demands(problem)) names.push_back(demand.name);
  return names;
}

Problem without_demand(const Problem& problem, const std::string& name) {
  Problem without = problem;
  for (const Demand& demand : all_demands(problem)) {
    if (demand.name == name) demand.leave_out(without);
  }
  return without;
}

ConflictMember conflict_member(const Problem& problem, const std::string& demand,
                               const SizedDesign& without_it) {
  for (const Demand& each : all_demands(problem)) {
    if (each.name == demand) return member(each, without_it, is_topology_open(problem));
  }
  return {demand, without_it.design, ""};
}

std::optional<std::vector<ConflictMember>> floor_conflict(const Problem& problem,
                                                          const SynthesisOptions& options) {
  std::vector<ConflictMember> members;
  Problem kept = problem;
  for (const Demand& demand : all_demands(problem)) {
    Problem without = kept;
    demand.leave_out(without);
    const SynthesisResult found = any_design(without, options);
    if (found.best) {
      members.push_back(member(demand, *found.best, is_topology_open(problem)));
    } else if (found.status == SynthesisStatus::kInfeasible) {
      kept = std::move(without);
    } else {
      return std::nullopt;
    }
  }
  return members;
}

void explain_conflict(const Problem& problem, const SynthesisOptions& options,
                      SynthesisResult& result) {
  result.conflict = floor_conflict(problem, options);
  if (!result.conflict) return;
  result.left_out = demands_of(problem);
  for (const ConflictMember& member : *result.conflict) {
    std::erase(result.left_out, member.constraint);
  }
}

}  // namespace torquewright::gearbox
