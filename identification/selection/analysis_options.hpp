// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace torquewright::identification {

/// How one joint is analysed.
struct AnalysisOptions {
  bool select = true;                ///< False: residual, noise floor and structure only.
  double tolerance = 0.001;          ///< Share of what is predicted below which nothing matters.
  std::uint64_t seed = 1;            ///< Of the noise replicas.
  std::vector<std::string> only;     ///< Effects that are asked about; empty: all ...
  std::vector<std::string> without;  ///< ... but these.
  /// By joint and quantity; else chosen by what stands out.
  std::map<std::pair<std::string, std::string>, double> band_Hz;
  /// Called with what is being done, and how much of all is done (0 to 1).
  std::function<void(const std::string&, double)> progress;
  /// Called often, while models are fitted; what it throws ends the work. May be empty.
  std::function<void()> before_each_fit;

  bool asks(const std::string& effect) const;
};

}  // namespace torquewright::identification
