// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/synthesis_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "gearbox/synthesis/synthesis_spec.hpp"
#include "src/report/gearbox/design_text.hpp"

namespace torquewright::report {
namespace {

using namespace gearbox;

std::string verdict(const SynthesisResult& result) {
  switch (result.status) {
    case SynthesisStatus::kOptimal:
      return fmt::format("optimal: proved within {:.2g} %, nothing is lighter than {:.6g} g.\n",
                         100.0 * (1.0 - result.bound_kg / result.best->mass_kg),
                         1e3 * result.bound_kg);
    case SynthesisStatus::kInfeasible:
      return "infeasible: no design satisfies all constraints, whatever its shifts.\n";
    case SynthesisStatus::kLimit:
      break;
  }
  if (!result.best) return "limit: the search was ended before it found a design.\n";
  return "limit: the search was ended; what follows is the best so far.\n";
}

std::string sizes_text(const Problem& problem, const SizedDesign& sized) {
  const TorqueLimit& borne = sized.borne;
  return fmt::format(
      "Face widths: layer 1 {:.6g} mm, layer 2 {:.6g} mm. The teeth bear {:.6g} of {:.6g} Nm ({}); "
      "{} of {} in {} ends it.\n",
      sized.face_width_mm[0], sized.face_width_mm[1], borne.joint_Nm,
      io::nearest(*problem.load_output_torque_Nm), *problem.steel,
      borne.mode == FailureMode::kBending ? "bending at the root" : "pressure on the flank",
      borne.gear, borne.mesh);
}

std::string search_text(const SynthesisResult& result) {
  std::string text = fmt::format(
      "Search: {} choices of teeth, planets and modules meet ratio and assembly, {} were opened, "
      "{} "
      "boxes (parts of the space of sizes).\n",
      result.choices, result.opened, result.boxes);
  for (const auto& [name, count] : result.excluded_by) {
    text += fmt::format("  {} of them excluded by {} alone\n", count, name);
  }
  return text;
}

}  // namespace

std::string synthesis_text(const Problem& problem, const SynthesisResult& result) {
  std::string text = verdict(result);
  text += fmt::format("Held fixed: {}.\n", held_fixed_by_synthesis(problem));
  if (result.best) {
    for (const std::string& sentence : not_asked_by_synthesis()) {
      text += "Not asked: " + sentence + "\n";
    }
    text += "1. " + design_text(result.best->problem, result.best->report);
    text += sizes_text(problem, *result.best);
  }
  if (std::isfinite(result.bound_kg) && result.bound_kg > 0.0) {
    text += fmt::format("Bound that nothing beats: {:.8g}\n", result.bound_kg);
  }
  if (!problem.assumed.empty()) {
    text += fmt::format("Assumed, neither published nor measured: {}.\n",
                        fmt::join(problem.assumed, ", "));
  }
  return text + search_text(result);
}

}  // namespace torquewright::report
