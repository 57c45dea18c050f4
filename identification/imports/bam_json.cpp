// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/file_json.hpp"
#include "identification/imports/named_columns.hpp"
#include "io/faults/json_text.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

using nlohmann::json;

struct Key {
  const char* name;
  Meaning meaning;
};
constexpr std::array kKeys = {
    Key{"timestamp", {Quantity::kTime}},
    Key{"position", {Quantity::kOutputPosition}},
    Key{"speed", {Quantity::kOutputVelocity}},
    Key{"goal_position", {Quantity::kCommandedPosition}},
    Key{"torque_enable", {Quantity::kEnabled}},
    Key{"input_volts", {Quantity::kBusVoltage}},
    Key{"temp", {Quantity::kWindingTemperature, 1.0, kCelsius_K}},
};
/// Of registers whose scale the file does not say.
constexpr std::array kUnscaled = {"present_current", "torque_demand"};

/// The pendulum of BAM's test bench as one body: m at L and a rod of m_a from the axis to L.
Load pendulum(const JsonFile& file) {
  const double mass_kg = file.number("mass"), length_m = file.number("length");
  const double arm_kg = file.root.contains("arm_mass") ? file.number("arm_mass") : 0.0;
  Load load;
  load.type = LoadType::kPendulum;
  load.mass_kg = mass_kg + arm_kg;
  load.length_m = (mass_kg + 0.5 * arm_kg) * length_m / load.mass_kg;
  load.inertia_kg_m2 =
      (mass_kg + arm_kg / 3.0) * length_m * length_m - load.mass_kg * load.length_m * load.length_m;
  load.inertia_kg_m2 = std::max(0.0, load.inertia_kg_m2);
  return load;
}

/// A share of the bus voltage (XL330), or a register's counts; 0 all through where it was not read.
bool is_duty(const JsonFile& file) {
  double greatest = 0.0;
  for (const json& entry : file.root["entries"]) {
    if (!entry.contains("load") || !entry["load"].is_number()) return false;
    greatest = std::max(greatest, std::abs(entry["load"].get<double>()));
  }
  return greatest > 0.0 && greatest <= 1.0;
}

void add_use(const char* name, const Meaning& meaning, ImportedLog& log) {
  log.header.emplace_back(name);
  log.columns.push_back({name, meaning.quantity, meaning.scale, meaning.offset, ""});
}

/// The first entry's keys are those of all.
void set_columns(const JsonFile& file, ImportedLog& log) {
  const json& first = file.root["entries"][0];
  for (const Key& key : kKeys) {
    if (first.contains(key.name)) add_use(key.name, key.meaning, log);
  }
  for (const char* name : {"timestamp", "position"}) {
    if (!first.contains(name)) file.refuse("/entries/0", fmt::format("{} is missing", name));
  }
  if (is_duty(file)) add_use("load", {Quantity::kDuty}, log);
  // eRob's recorder: the current of its drive.
  if (first.contains("torque_demand")) add_use("control", {Quantity::kMotorCurrent}, log);
  std::set<std::string> known{"load", "control"};
  known.insert(kUnscaled.begin(), kUnscaled.end());
  for (const Key& key : kKeys) known.insert(key.name);
  for (const auto& [key, value] : first.items()) {
    if (!known.contains(key)) file.refuse(io::child_path("/entries/0", key), "not understood");
    if (std::find(log.header.begin(), log.header.end(), key) == log.header.end()) {
      log.notes.push_back("not read, its scale is not said: " + key);
    }
  }
}

ImportedLog::Run run_of(const JsonFile& file, const std::string& name, const ImportedLog& log) {
  ImportedLog::Run run{name, {}};
  for (std::size_t i = 0; i < file.root["entries"].size(); ++i) {
    const json& entry = file.root["entries"][i];
    std::vector<std::string>& row = run.rows.emplace_back();
    for (const std::string& key : log.header) {
      const std::string path = fmt::format("/entries/{}/{}", i, key);
      if (!entry.contains(key)) file.refuse(path, "missing; the first entry has it");
      row.push_back(file.number_text(entry[key], path));
    }
  }
  return run;
}

ImportedLog read_bam(const ImportRequest& request) {
  ImportedLog log;
  for (const std::filesystem::path& path : request.files) {
    const JsonFile file(path);
    file.refuse_unknown({"mass", "arm_mass", "length", "kp", "vin", "damping", "motor",
                         "trajectory", "entries", "dt"});
    if (!file.root.contains("entries") || !file.root["entries"].is_array() ||
        file.root["entries"].empty()) {
      file.refuse("/entries", "missing; must be a list");
    }
    if (log.header.empty()) set_columns(file, log);
    const std::string name = io::stem_in_text(path);
    log.runs.push_back(run_of(file, name, log));
    log.loads[name] = pendulum(file);
    if (!file.root.contains("arm_mass")) {
      for (const char* key : {"/mass_kg", "/length_m", "/inertia_kg_m2"}) {
        log.assumed.push_back(io::child_path("/loads", name) + key);
      }
      log.notes.push_back(fmt::format("{}: no arm_mass; the arm is taken for massless",
                                      io::name_in_text(file.file)));
    }
  }
  return log;
}

}  // namespace

const Importer bam = {"bam", "JSON of Rhoban's bam recorders: a servo with a pendulum",
                      "https://github.com/Rhoban/bam", read_bam};

}  // namespace torquewright::identification::imports
