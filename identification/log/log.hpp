// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "identification/log/runs.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// Severity of a finding about the data.
enum class Weight { kNote, kWarning, kError };
struct DataFinding {
  Weight weight = Weight::kNote;
  std::string sentence;
};

/// Standard size of the last written digit of a channel's numbers, in its unit, by Quantity; 0: not
/// known.
using PrintedSteps = std::array<double, kQuantityCount>;

struct Log {
  Runs runs;  ///< The runs; a long log (kLongestWholeLog) has its stretches in pieces.
  std::vector<std::string> train_runs;  ///< Names of the runs that may be fitted.
  std::vector<std::string> holdout_runs;
  std::vector<DataFinding> findings;
  struct File {
    std::string path;
    std::string sha256;
  };
  std::vector<File> files;
  /// Last digits by joint; empty for a log that was not read from files.
  std::vector<PrintedSteps> printed = {};
};

}  // namespace torquewright::identification
