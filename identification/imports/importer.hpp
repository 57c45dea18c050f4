// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

struct ImportRequest {
  std::vector<std::filesystem::path> files;
  std::string joint;  ///< Name of the joint, as the file calls it, where a file holds several.
  std::string units;  ///< Unit of positions, where no file says it and the user does.
  /// Topics of recordings, where they hold several of joint states: that of what was measured, and
  /// that of what was commanded.
  std::string topic, commands;
  bool by_recorders_clock = false;  ///< Times are when messages came, not when they were stamped.
};

/// Takes the cells of a row, in the header's order.
using RowSink = std::function<void(const std::string& run, const std::vector<std::string>& cells)>;

/// A log of another program: its numbers as they were written, and what its columns are.
struct ImportedLog {
  std::vector<std::string> header;  ///< Names of the columns, without the run's.
  struct Run {
    std::string name;
    std::vector<std::vector<std::string>> rows;  ///< Cells of each row, in the header's order.
  };
  std::vector<Run> runs;
  /// Gives the rows of all runs, in order, where they may be too many to be held: then those of
  /// `runs` are empty. Null otherwise. Throws io::SpecError where a file turns out not to be read.
  std::function<void(const RowSink& sink)> stream;
  std::vector<ColumnUse> columns;
  std::vector<std::string> ignore;
  std::optional<Load> load;  ///< The load; where it is absent the user has to state it.
  std::map<std::string, Load> loads;
  std::vector<std::string> assumed;  ///< Pointers to values of the rig that are assumed.
  std::vector<std::string> notes;    ///< Sentences for the user about what was read.
};

/// A format of logs. Each is one file in this folder and one line in every_importer.hpp. It throws
/// io::SpecError for what it does not understand, by name.
struct Importer {
  std::string_view name;    ///< Name on the command line.
  std::string_view what;    ///< Description for the help.
  std::string_view source;  ///< Where the format is documented.
  ImportedLog (*read)(const ImportRequest& request);
  bool asks_joint = false;  ///< Its files may hold several joints.
  bool asks_units = false;  ///< Its files do not state the unit of positions.
  bool asks_topic = false;  ///< Its files are recordings of topics.
};

std::span<const Importer* const> importer_library();

/// Returns the importer of that name. Throws io::SpecError with the nearest name where there is
/// none.
const Importer& importer_of(std::string_view name);

}  // namespace torquewright::identification
