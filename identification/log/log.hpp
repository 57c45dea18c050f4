// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
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

/// Reads the logs of one rig. Unambiguous faults are repaired with a finding (wrapped angles,
/// isolated impossible samples, saturated channels, gaps: a gap cuts a run in two of one name);
/// what cannot be read or would mislead throws io::SpecError. A log of more rows than may be in
/// memory comes in pieces. docs/logs.md says which is which.
Log read_log(const std::vector<std::filesystem::path>& files, const Rig& rig,
             std::size_t most_rows_in_memory = kLongestWholeLog);

/// Checks what only the nominal actuators (one per joint, in the order of Rig::joints) can tell: a
/// current in mA, angles in degrees on both of position and velocity, signs of motor and torque.
/// Adds findings, or throws io::SpecError with what to write into the rig. Where a check rests on a
/// constant that the rig calls uncertain it only warns.
void check_against(Log& log, const Rig& rig, const std::vector<actuator::Actuator>& actuators);

}  // namespace torquewright::identification
