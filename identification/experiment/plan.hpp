// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "identification/experiment/excitation.hpp"
#include "identification/experiment/planned_columns.hpp"
#include "identification/experiment/separability.hpp"

namespace torquewright::identification {

struct PlanOptions {
  std::vector<std::string> separate;  ///< Names of the contract; empty: what a rig mostly shows.
  double duration_s = 40.0;
  RigLimits limits;
  std::map<Quantity, double> noise;  ///< Standard deviations; else typical ones (plan_trial.hpp).
  /// Drawn; the best of them is then refined as often. Fewer of long ones: see tries_of().
  std::size_t candidates = 24;
  std::uint64_t seed = 1;  ///< Of the random search.
};

/// Sigma of a parameter to be expected, and how well it stands apart, under one excitation.
struct Expected {
  double standard_error = 0.0;
  double share = 0.0;
  std::string nearest;            ///< Effect; its own where another parameter of it is nearest.
  std::string nearest_parameter;  ///< Of it.
};

struct PlannedParameter {
  PlannedColumn column;
  /// Such that the effect costs 5 % of the actuator's greatest torque at most, along the chirp.
  double typical = 0.0;
  Expected plan, chirp;
  bool is_separable = false;  ///< By the plan: kSeparableShare, and a typical value at 3 sigma.
  std::string remedy;         ///< What separates it from its nearest, in words.
};

struct Plan {
  std::vector<ExcitationRun> runs;
  std::vector<ExcitationRun> chirp;
  std::vector<PlannedParameter> parameters;
  double smallest_eigenvalue = 0.0, chirp_smallest_eigenvalue = 0.0;
  std::map<Quantity, double> noise;
  std::size_t tried = 0;
  struct Unseen {
    std::vector<std::string> effects;
    std::string why;
    std::string remedy;
  };
  std::vector<Unseen> unseen;  ///< What no excitation shows, or tells apart, on this rig.
  bool is_separable() const;
};
constexpr double kSeparableShare = 0.02;  ///< Correlation with all others below 0.99.

/// How many excitations are drawn: as many as asked for, but no more than take kMostTried_s of
/// simulated time all together (at least two), for each is simulated several times.
std::size_t tries_of(const PlanOptions& options);
constexpr double kMostTried_s = 5760.0;

/// Searches an excitation that separates the effects: the chirp, drawn ones, and the best of those
/// refined. None is worse for the effect that is worst off than the chirp. The same question gives
/// the same answer. Throws io::SpecError for names that the contract does not have, several joints,
/// a rig without a torque balance, and limits that leave no motion.
Plan plan_excitation(const Rig& rig, const actuator::Actuator& actuator,
                     const PlanOptions& options);

}  // namespace torquewright::identification
