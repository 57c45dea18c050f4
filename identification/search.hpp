// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/acceptance.hpp"

namespace torquewright::identification {

/// Why an effect did not come in.
struct Rejection {
  std::string effect;
  std::string reason;
};

/// Others that explain what a member explains as well.
struct Group {
  std::size_t member = 0;            ///< Place in the model.
  std::vector<std::string> effects;  ///< The member's own first.
};

/// The outcome of the search over sets of effects.
struct Selection {
  Fit model;
  Fit empty;                ///< Nothing but what stands always.
  std::vector<Gain> gains;  ///< Of each member, against its own removal.
  std::vector<Fit> path;    ///< The models with members 1, 2, ... in the order of gain.
  std::vector<Group> groups;
  std::vector<Rejection> rejected;
};

struct SearchOptions {
  AcceptanceRules rules;
  bool target_is_motor_side = false;
  bool is_free_load = false;
  std::vector<std::size_t> variants;  ///< Candidates.
};

/// Adds effects one at a time while they earn it where they were not fitted, from two starts; every
/// member is examined again after each addition. docs/derivations/identification.md section 4.
Selection search(const Fitter& fitter, const SearchOptions& options);

}  // namespace torquewright::identification
