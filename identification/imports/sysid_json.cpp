// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/file_json.hpp"
#include "identification/imports/sysid_columns.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::identification::imports {
namespace {

using nlohmann::json;

constexpr std::array kTests = {"slow-forward", "slow-backward", "fast-forward", "fast-backward"};

/// Positions are in rotations of the output; a unit says what one of them is.
const PositionUnit& unit_of_file(const JsonFile& file) {
  const std::string name = file.text("units");
  const PositionUnit* unit = find_position_unit(name);
  if (unit == nullptr) file.refuse("/units", fmt::format("\"{}\" is not known", name));
  return *unit;
}

void add_runs(const JsonFile& file, const std::string& prefix, ImportedLog& log) {
  for (const char* test : kTests) {
    if (!file.root.contains(test)) continue;
    if (!file.root[test].is_array()) {
      file.refuse(fmt::format("/{}", test),
                  "must be a list of [timestamp, voltage, position, velocity]");
    }
    ImportedLog::Run run{prefix + test, {}};
    for (std::size_t i = 0; i < file.root[test].size(); ++i) {
      const json& entry = file.root[test][i];
      const std::string path = fmt::format("/{}/{}", test, i);
      if (!entry.is_array() || entry.size() != log.header.size()) {
        file.refuse(path, "must be [timestamp, voltage, position, velocity]");
      }
      std::vector<std::string>& row = run.rows.emplace_back();
      for (const json& cell : entry) row.push_back(file.number_text(cell, path));
    }
    if (!run.rows.empty()) log.runs.push_back(std::move(run));
  }
}

ImportedLog read_sysid(const ImportRequest& request) {
  ImportedLog log;
  for (const std::filesystem::path& path : request.files) {
    const JsonFile file(path);
    file.refuse_unknown({"slow-forward", "slow-backward", "fast-forward", "fast-backward", "sysid",
                         "test", "units", "unitsPerRotation"});
    const std::string test = file.text("test");
    if (test != "Simple" && test != "Elevator" && test != "Arm") {
      file.refuse("/test",
                  fmt::format("\"{}\": only Simple, Elevator and Arm are one actuator", test));
    }
    const std::vector<ColumnUse> before = log.columns;
    set_sysid_columns(unit_of_file(file), file.number("unitsPerRotation"), log);
    if (!before.empty() && (before[2].quantity != log.columns[2].quantity ||
                            before[2].scale != log.columns[2].scale)) {
      file.refuse("/units", "other units than in the file before it");
    }
    add_runs(file, request.files.size() > 1 ? io::stem_in_text(path) + " " : "", log);
    log.notes.push_back(
        fmt::format("{}: a test of kind \"{}\"; the voltage is taken for the winding's",
                    io::name_in_text(file.file), test));
  }
  return log;
}

}  // namespace

const Importer sysid = {"sysid", "WPILib SysId's JSON: slow-forward, fast-backward, ...",
                        "https://github.com/wpilibsuite/allwpilib/blob/main/sysid/docs/"
                        "data-collection.md",
                        read_sysid};

}  // namespace torquewright::identification::imports
