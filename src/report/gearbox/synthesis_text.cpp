// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/synthesis_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/synthesis/synthesis_spec.hpp"
#include "src/report/gearbox/design_text.hpp"

namespace torquewright::report {
namespace {

using namespace gearbox;

std::string among_topologies(const SynthesisResult& result) {
  if (result.topologies.empty()) return "";
  return fmt::format(" of {} topologies", result.topologies.size());
}

/// Of a problem that leaves the topology open: what each of them has.
std::string topologies_text(const SynthesisResult& result) {
  std::string text;
  for (const TopologyAnswer& answer : result.topologies) {
    text += design_line(answer.topology, topology_sentence(answer));
  }
  return text.empty() ? "" : "Topologies:\n" + text;
}

std::string verdict(const SynthesisResult& result) {
  switch (result.status) {
    case SynthesisStatus::kOptimal:
      return fmt::format("optimal: proved within {:.2g} %, nothing{} is lighter than {:.6g} g.",
                         100.0 * (1.0 - result.bound_kg / result.best->mass_kg),
                         among_topologies(result), 1e3 * result.bound_kg);
    case SynthesisStatus::kInfeasible:
      return fmt::format("infeasible: no design{} satisfies all constraints, whatever its shifts.",
                         among_topologies(result));
    case SynthesisStatus::kLimit:
      break;
  }
  if (!result.best) return "limit: the search was ended before it found a design.";
  return "limit: the search was ended; what follows is the best so far.";
}

std::string widths_line(const SizedDesign& sized) {
  const auto& [first, second] = sized.face_width_mm;
  if (train_parts(sized.problem.topology).layer_count() < 2) {
    return design_line("face width", fmt::format("{:.6g} mm", first));
  }
  return design_line("face widths",
                     fmt::format("layer 1 {:.6g} mm, layer 2 {:.6g} mm", first, second));
}

std::string design_of(const SizedDesign& sized, bool has_all) {
  const std::string widths = widths_line(sized);
  if (!has_all) return "1. " + design_screen(sized.problem, sized.report) + widths;
  return "1. " + design_text(sized.problem, sized.report) + widths +
         strength_line(sized.problem, sized.report);
}

std::string not_asked_text(bool has_all) {
  if (!has_all) {
    return "Not asked: rims, uneven load on wide teeth, carrier, bearings and shafts.\n";
  }
  std::string text;
  for (const std::string& sentence : not_asked_by_synthesis()) {
    text += "Not asked: " + sentence + "\n";
  }
  return text;
}

std::string search_text(const SynthesisResult& result) {
  std::string text = fmt::format(
      "Search: {} choices of teeth, planets and modules meet ratio and assembly; {} of them were "
      "opened; {} boxes (parts of the space of sizes) were searched.\n",
      result.choices, result.opened, result.boxes);
  for (const auto& [name, count] : result.excluded_by) {
    text += fmt::format("  {} of them are excluded by {} alone\n", count, name);
  }
  return text;
}

/// Of a problem without design: what stands in its way.
std::string conflict_text(const SynthesisResult& result) {
  if (result.status != SynthesisStatus::kInfeasible) return "";
  if (!result.conflict) return "What conflicts was not settled in time.\n";
  if (result.conflict->empty()) {
    return "No load, face width, floor or ceiling is to blame: without all of them there is no "
           "design either.\n";
  }
  std::string text = "These conflict, and would not without any one of them:\n";
  for (const ConflictMember& member : *result.conflict) {
    text += fmt::format("  {}: {}\n", member.constraint, member.sentence);
  }
  return text;
}

}  // namespace

std::string synthesis_answer(const SynthesisResult& result) {
  if (!result.best) return verdict(result);
  return fmt::format("{} Strength: {}", verdict(result),
                     strength_statement(result.best->problem, result.best->design));
}

std::string synthesis_text(const Problem& problem, const SynthesisResult& result, bool has_all) {
  std::string text = verdict(result) + "\n" + topologies_text(result);
  const Problem& of_design = result.best ? result.best->problem : problem;
  text += fmt::format("Held fixed: {}.\n", held_fixed_by_synthesis(of_design));
  text += conflict_text(result);
  if (result.best) text += not_asked_text(has_all) + design_of(*result.best, has_all);
  const bool is_open = result.status == SynthesisStatus::kLimit;
  if ((has_all || is_open) && std::isfinite(result.bound_kg) && result.bound_kg > 0.0) {
    text += fmt::format("Bound that nothing beats: {:.8g}\n", result.bound_kg);
  }
  if (!problem.assumed.empty()) {
    text += fmt::format("Assumed, neither published nor measured: {}.\n",
                        fmt::join(problem.assumed, ", "));
  }
  return text + (has_all || !result.best ? search_text(result) : "");
}

}  // namespace torquewright::report
