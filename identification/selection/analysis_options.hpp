// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace torquewright::identification {

/// Options of the analysis of one joint.
struct AnalysisOptions {
  bool select = true;        ///< False: residual, noise floor and structure only, no search.
  double tolerance = 0.001;  ///< Share of the predicted quantity below which no change matters.
  std::uint64_t seed = 1;    ///< Seed of the noise replicas.
  std::vector<std::string> only;     ///< Names of the effects to search for; empty: all.
  std::vector<std::string> without;  ///< Names of effects not to search for.
  /// Cut-off of an equation's band by joint and quantity; where absent, chosen by what stands out
  /// of the noise.
  std::map<std::pair<std::string, std::string>, double> band_Hz;
  /// Called with a text about the present step and the share of all work that is done (0 to 1).
  std::function<void(const std::string&, double)> progress;
  /// Called often, while models are fitted; what it throws ends the work. May be empty.
  std::function<void()> before_each_fit;

  bool asks(const std::string& effect) const;
};

}  // namespace torquewright::identification
