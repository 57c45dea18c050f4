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
  /// Names of the effects to separate; empty: those that such a rig usually shows.
  std::vector<std::string> separate;
  double duration_s = 40.0;
  RigLimits limits;
  /// Standard deviations of the sensors' noise; where absent, typical ones (plan_trial.hpp).
  std::map<Quantity, double> noise;
  /// Number of random excitations; the best one is then refined as often. Long ones are tried less
  /// often: see tries_of().
  std::size_t candidates = 24;
  std::uint64_t seed = 1;  ///< Seed of the random search.
};

/// The standard error to be expected of a parameter under one excitation, and how well it stands
/// apart from the others.
struct Expected {
  double standard_error = 0.0;
  double share = 0.0;
  /// The effect it is most easily confused with; its own where another parameter of it is.
  std::string nearest;
  std::string nearest_parameter;  ///< The parameter of `nearest`.
};

struct PlannedParameter {
  PlannedColumn column;
  /// A typical value: one at which the effect costs at most 5 % of the actuator's greatest torque
  /// along the chirp.
  double typical = 0.0;
  Expected plan, chirp;
  /// Whether the plan tells it apart: its share is above kSeparableShare and its typical value
  /// above 3 sigma.
  bool is_separable = false;
  std::string remedy;  ///< A sentence: what would separate it from its nearest.
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
/// Least share of a separable parameter: its correlation with all others is below 0.99. A choice of
/// ours.
constexpr double kSeparableShare = 0.02;

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
