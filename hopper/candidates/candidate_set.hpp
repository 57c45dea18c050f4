// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {

/// A transmission that may take the place of a drivetrain's actuators.
struct Candidate {
  std::string name;  ///< Name of its file, with the ratio where that was changed.
  actuator::Actuator actuator;
};

/// Gear ratios to try on every candidate, from least to greatest.
struct RatioSweep {
  double from = 1.0;
  double to = 1.0;
  double step = 1.0;
  std::vector<double> ratios() const;
};

/// Reads FROM:TO or FROM:TO:STEP. Throws io::SpecError.
RatioSweep read_ratio_sweep(const std::string& text);

/// The documents of a folder that can drive a drivetrain: every actuator, and every gearbox or
/// gearbox_result on the drivetrain's own motor.
struct CandidateSet {
  std::vector<std::vector<Candidate>> by_drivetrain;
  std::vector<io::Document> documents;
  /// Sentences about documents that are no candidates, or broken.
  std::vector<std::string> left_out;
};

/// Reads a folder (not those inside it), in the order of the names. Throws io::SpecError where it
/// is none, or holds nothing that can drive anything.
CandidateSet read_candidate_set(const std::filesystem::path& folder, const ReadRobot& robot,
                                const std::optional<RatioSweep>& sweep);

/// The actuators of the catalogue that is compiled in, the shelf of `actuator find`.
CandidateSet catalogue_candidates(const ReadRobot& robot, const std::optional<RatioSweep>& sweep);

}  // namespace torquewright::hopper
