// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/draft/column_guess.hpp"
#include "identification/draft/log_sample.hpp"

namespace torquewright::identification {

/// A rig as a log's header and numbers suggest it.
struct RigDraft {
  std::vector<ColumnGuess> columns;  ///< In the order of the header.
  /// A torque sensor stands at the output of the one joint: whatever moves it, a sensor measures
  /// it.
  bool is_dynamometer = false;
  std::vector<std::string> joints;  ///< Names in the columns; empty where there is one joint.
  /// Row, from 0, at which time begins again though no column names runs; 0: none.
  std::size_t unnamed_run = 0;
  std::vector<std::string> open;  ///< Sentences on what the log does not say.
};

/// Drafts the rig of a log (CSV) from its header, the units under it and its first rows. What is
/// guessed is marked (ColumnGuess::is_sure), and says by what. Throws io::SpecError where the file
/// is no table or none of its columns is known.
RigDraft draft_rig(const std::filesystem::path& log);

}  // namespace torquewright::identification
