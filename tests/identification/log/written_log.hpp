// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/reading/read_log.hpp"
#include "io/documents/document.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::test {

/// Columns by name and quantity; the load of a dynamometer.
inline nlohmann::json rig_json(const std::vector<std::pair<std::string, std::string>>& columns) {
  nlohmann::json rig = {{"kind", "rig"}, {"version", 1}, {"load", {{"type", "dynamometer"}}}};
  for (const auto& [column, quantity] : columns) rig["columns"][column] = quantity;
  return rig;
}

inline identification::Rig rig_of(const nlohmann::json& rig) {
  return identification::read_rig(io::check_document(rig, "rig", "rig.json", ""));
}

using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// The log in these files, or what is refused of it.
struct ReadLog {
  identification::Log log;
  std::string refusal;

  /// The only finding that holds these words; empty where none or several do.
  identification::DataFinding finding(const std::string& words) const {
    identification::DataFinding found;
    int count = 0;
    for (const auto& one : log.findings) {
      if (one.sentence.find(words) == std::string::npos) continue;
      found = one;
      ++count;
    }
    return count == 1 ? found : identification::DataFinding();
  }
};

inline ReadLog read(const NamedTexts& texts, const nlohmann::json& rig) {
  const ScratchFolder folder;
  std::vector<std::filesystem::path> files;
  for (const auto& [name, text] : texts) files.push_back(folder.write(name, text));
  ReadLog result;
  result.refusal =
      refusal([&] { result.log = identification::read_log(files, rig_of(rig)); }, folder.path());
  return result;
}

}  // namespace torquewright::test
