// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/problem_strength.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "gearbox/strength/steels.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

double assumed_load_sharing(std::int64_t planets) {
  return planets <= 3   ? 1.1
         : planets == 4 ? 1.25
         : planets == 5 ? 1.35
         : planets == 6 ? 1.44
                        : 1.47;
}

/// Keys that the strength of teeth needs and the problem does not state.
std::vector<std::string> missing_keys(const Problem& problem) {
  std::vector<std::string> keys;
  if (!problem.steel) keys.emplace_back("/materials/steel");
  if (problem.face_width_mm.empty()) keys.emplace_back("/face_width_mm");
  return keys;
}

std::string borne_sentence(const StrengthCase& strength, const Problem& problem) {
  const TorqueLimit limit = torque_limits(strength).for_cycles;
  return fmt::format(
      "the teeth bear {:.4g} Nm at the output, where {:.6g} Nm act ({}, {:.6g} loads{}); {} of {} "
      "in {} sets their limit.",
      limit.joint_Nm, io::nearest(*problem.load_output_torque_Nm), *problem.steel, strength.cycles,
      problem.load_cycles ? "" : " assumed",
      limit.mode == FailureMode::kBending ? "bending at the root" : "pressure on the flank",
      limit.gear, limit.mesh);
}

std::string strength_sentence(const Problem& problem, const std::vector<Design>& designs) {
  if (!problem.load_output_torque_Nm || *problem.load_output_torque_Nm == 0) {
    return "strength: no load is stated.";
  }
  const std::string load =
      fmt::format("the load of {:.6g} Nm", io::nearest(*problem.load_output_torque_Nm));
  const std::vector<std::string> missing = missing_keys(problem);
  if (!missing.empty()) {
    return fmt::format("strength: whether the teeth bear {} is not known without {}.", load,
                       fmt::join(missing, " and "));
  }
  if (designs.empty()) return fmt::format("strength: whether teeth bear {}.", load);
  const auto strength = strength_of_design(problem, designs.front());
  if (!strength) return "strength: stresses of these teeth cannot be computed.";
  return "strength: " + borne_sentence(*strength, problem);
}

/// The problem with what its strength needs, and which of it was assumed.
Problem with_strength_assumed(Problem problem, const Design& design,
                              std::vector<std::string>& assumed) {
  if (!problem.steel) {
    problem.steel = kAssumedSteel;
    assumed.push_back(fmt::format("steel {}", kAssumedSteel));
  }
  if (problem.face_width_mm.empty()) {
    const Rational width_mm = kAssumedFaceModules * design.module_mm;
    for (const std::string& layer : train_parts(problem.topology).layer_names()) {
      problem.face_width_mm[layer] = width_mm;
    }
    assumed.push_back(fmt::format("face widths of {:g} mm", io::nearest(width_mm)));
  }
  return problem;
}

}  // namespace

LoadFactors assumed_factors(std::int64_t planet_count) {
  return {.application = 1.0,
          .dynamic = 1.0,
          .load_sharing = assumed_load_sharing(planet_count),
          .face_load_root = 1.2,
          .face_load_flank = 1.3,
          .alternating_bending = 0.7};
}

std::optional<StrengthCase> strength_of_design(const Problem& problem, const Design& design) {
  if (!missing_keys(problem).empty()) return std::nullopt;
  const Steel* steel = find_steel(*problem.steel);
  if (steel == nullptr) return std::nullopt;
  StrengthCase strength;
  strength.train = gear_train(problem, design);
  for (const std::string& layer : train_parts(problem.topology).layer_names()) {
    const auto width = problem.face_width_mm.find(layer);
    if (width == problem.face_width_mm.end()) return std::nullopt;
    strength.train.face_width_mm.push_back(io::nearest(width->second));
  }
  strength.material = steel->material;
  strength.factors = assumed_factors(design.planet_count);
  strength.cycles = problem.load_cycles ? io::nearest(*problem.load_cycles) : kAssumedCycles;
  strength.demanded_root_safety = kAssumedRootSafety;
  strength.demanded_flank_safety = kAssumedFlankSafety;
  if (!objections(strength.train).empty()) return std::nullopt;
  return strength;
}

std::string held_fixed(const Problem& problem) {
  const bool has_layers = train_parts(problem.topology).layer_count() > 1;
  return fmt::format("no profile shift{}{}",
                     has_layers ? ", one module for both layers, rings coaxial by their teeth" : "",
                     problem.face_width_mm.empty() ? "" : ", face widths as stated");
}

std::string strength_statement(const Problem& problem, const Design& design) {
  if (!problem.load_output_torque_Nm || *problem.load_output_torque_Nm == 0) {
    return "not judged: no load is stated";
  }
  std::vector<std::string> assumed;
  const Problem whole = with_strength_assumed(problem, design, assumed);
  const auto strength = strength_of_design(whole, design);
  if (!strength) return "not judged: stresses of these teeth cannot be computed";
  const bool bears =
      torque_limits(*strength).for_cycles.joint_Nm >= io::nearest(*problem.load_output_torque_Nm);
  const std::string told =
      (bears ? "" : "does not bear the load: ") + borne_sentence(*strength, whole);
  if (assumed.empty()) return told;
  return fmt::format("{} Assumed: {}.", told, fmt::join(assumed, ", "));
}

std::vector<std::string> not_asked(const Problem& problem, const std::vector<Design>& designs) {
  return {strength_sentence(problem, designs)};
}

}  // namespace torquewright::gearbox
