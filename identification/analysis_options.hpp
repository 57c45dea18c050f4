// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace torquewright::identification {

/// How one joint is analysed.
struct AnalysisOptions {
  bool select = true;                ///< False: residual, noise floor and structure only.
  double tolerance = 0.002;          ///< Share of what is predicted below which nothing matters.
  std::uint64_t seed = 1;            ///< Of the noise replicas.
  std::vector<std::string> settled;  ///< Effects that are not asked about any more.
  /// Called with what is being done, and how much of all is done (0 to 1).
  std::function<void(const std::string&, double)> progress;
};

}  // namespace torquewright::identification
