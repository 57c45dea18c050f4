// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
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
  std::string joint;  ///< Which one, where a file holds several; as the file calls it.
  std::string units;  ///< Of positions, where no file says it and the user does.
};

/// Logs of another program: their numbers as they were written, and what their columns are.
struct ImportedLog {
  std::vector<std::string> header;  ///< But for the run.
  struct Run {
    std::string name;
    std::vector<std::vector<std::string>> rows;  ///< Cells in the header's order.
  };
  std::vector<Run> runs;
  std::vector<ColumnUse> columns;
  std::vector<std::string> ignore;
  std::optional<Load> load;  ///< Where neither stands, the user has to state it.
  std::map<std::string, Load> loads;
  std::vector<std::string> assumed;  ///< Pointers into the rig.
  std::vector<std::string> notes;    ///< Sentences.
};

/// A format. One file each in this folder, one line in every_importer.hpp. Throws io::SpecError for
/// what it does not understand, by name.
struct Importer {
  std::string_view name;    ///< As on the command line.
  std::string_view what;    ///< For the help.
  std::string_view source;  ///< Where the format is documented.
  ImportedLog (*read)(const ImportRequest& request);
  bool asks_joint = false;  ///< Its files may hold several.
  bool asks_units = false;  ///< Its files do not say what positions are in.
};

std::span<const Importer* const> importer_library();

/// Throws io::SpecError with the nearest for a name that no importer has.
const Importer& importer_of(std::string_view name);

}  // namespace torquewright::identification
