// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/files_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/faults/json_text.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

/// A name or a text with a comma or quote stands in quotes.
std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char letter : cell)
    text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + "\"";
}

std::string run_column(const ImportedLog& log) {
  std::string name = "run";
  while (std::find(log.header.begin(), log.header.end(), name) != log.header.end()) name += "_";
  return name;
}

ordered_json load_json(const Load& load) {
  ordered_json json = {{"type", name_of(load.type)}};
  json["mass_kg"] = load.mass_kg;
  json["length_m"] = load.length_m;
  json["inertia_kg_m2"] = load.inertia_kg_m2;
  return json;
}

ordered_json use_json(const ColumnUse& use) {
  const bool is_plain = use.scale == 1.0 && use.offset == 0.0 && use.joint.empty();
  if (is_plain) return name_of(use.quantity);
  ordered_json json = {{"quantity", name_of(use.quantity)}};
  if (use.scale != 1.0) json["scale"] = use.scale;
  if (use.offset != 0.0) json["offset"] = use.offset;
  if (!use.joint.empty()) json["joint"] = use.joint;
  return json;
}

}  // namespace

void imported_csv(const ImportedLog& log, const io::TextSink& sink) {
  constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
  std::string text = run_column(log);
  for (const std::string& name : log.header) text += "," + quoted(name);
  text += '\n';
  const auto add_row = [&](const std::string& run, const std::vector<std::string>& cells) {
    text += quoted(run);
    for (const std::string& cell : cells) text += "," + quoted(cell);
    text += '\n';
    if (text.size() < kPieceBytes) return;
    sink(text);
    text.clear();
  };
  if (log.stream) log.stream(add_row);
  for (const ImportedLog::Run& run : log.runs) {
    for (const std::vector<std::string>& row : run.rows) add_row(run.name, row);
  }
  sink(text);
}

std::string imported_rig(const ImportedLog& log, const std::string& name) {
  ordered_json rig = {{"kind", "rig"}, {"version", 1}, {"name", name}};
  rig["columns"][run_column(log)] = "run";
  for (const ColumnUse& use : log.columns) rig["columns"][use.column] = use_json(use);
  if (!log.ignore.empty()) rig["ignore"] = log.ignore;
  if (log.load) rig["load"] = load_json(*log.load);
  for (const auto& [run, load] : log.loads) rig["loads"][run] = load_json(load);
  if (!log.assumed.empty()) rig["assumed"] = log.assumed;
  return io::json_text(rig, 1);
}

}  // namespace torquewright::identification
