// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/result.hpp"

namespace torquewright::identification {

/// How effects are searched for.
enum class Method {
  kColumns,  ///< Columns are added to the residual of the stated actuator.
  kForward,  ///< The actuator's law itself is fitted, and sets of effects are judged.
};

struct AnalysisOptions {
  Method method = Method::kColumns;
  bool select = true;        ///< False: residual, noise floor and structure only.
  double tolerance = 0.002;  ///< Forward: share of what is predicted below which nothing matters.
  std::uint64_t seed = 1;    ///< Of the noise replicas.
  std::vector<std::string> settled;  ///< Effects that are not asked about any more.
  /// Called with what is being done, and how much of all is done (0 to 1).
  std::function<void(const std::string&, double)> progress;
};

/// Steps 2 to 5 for every equation that a joint's channels allow.
/// docs/derivations/identification.md.
std::vector<EquationResult> analyse(const Rig& rig, const Log& log, std::size_t joint,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const AnalysisOptions& options = {});

}  // namespace torquewright::identification
