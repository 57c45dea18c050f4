// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "actuator/actuator.hpp"
#include "identification/quantity.hpp"
#include "identification/rig.hpp"

namespace torquewright::identification {

/// Something to be said of the data.
enum class Weight { kNote, kWarning, kError };
struct DataFinding {
  Weight weight = Weight::kNote;
  std::string sentence;
};

/// The channels of one joint in one run, by Quantity; an empty one was not logged. What the log
/// states for all joints stands in each.
struct Channels {
  std::array<std::vector<double>, kQuantityCount> of;

  const std::vector<double>& operator[](Quantity quantity) const {
    return of[static_cast<std::size_t>(quantity)];
  }
  std::vector<double>& operator[](Quantity quantity) {
    return of[static_cast<std::size_t>(quantity)];
  }
  bool has(Quantity quantity) const { return !(*this)[quantity].empty(); }
};

/// A stretch of samples without a gap. All vectors are of one length.
struct Run {
  std::string name;
  std::vector<double> time_s;        ///< Ascending strictly; empty in a map without time.
  std::vector<Channels> joints;      ///< In the order of Rig::joints.
  std::vector<std::uint8_t> masked;  ///< 1: repaired or saturated; no residual counts there.
};

struct Log {
  std::vector<Run> runs;
  std::vector<std::string> train_runs;  ///< Names.
  std::vector<std::string> holdout_runs;
  std::vector<DataFinding> findings;
  struct File {
    std::string path;
    std::string sha256;
  };
  std::vector<File> files;
};

/// Reads the logs of one rig. Unambiguous faults are repaired with a finding (wrapped angles,
/// isolated impossible samples, saturated channels, gaps: a gap cuts a run in two of one name);
/// what cannot be read or would mislead throws io::SpecError. docs/logs.md says which is which.
Log read_log(const std::vector<std::filesystem::path>& files, const Rig& rig);

/// What only the nominal actuators (one per joint, in the order of Rig::joints) can tell: a current
/// in mA, angles in degrees on both of position and velocity, signs of motor and torque. Adds
/// findings, or throws io::SpecError with what to write into the rig. A constant that the rig calls
/// uncertain makes what rests on it a warning.
void check_against(Log& log, const Rig& rig, const std::vector<actuator::Actuator>& actuators);

}  // namespace torquewright::identification
