// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/sysid_columns.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/csv.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

/// A routine appends its values one after the other, each with a time stamp of its own, and the
/// loop that does so runs each 5 to 20 ms: rows nearer than this are one sample.
constexpr double kOneLoop_s = 2e-3;

constexpr std::array<std::string_view, 3> kValues = {"voltage", "position", "velocity"};
constexpr std::array<std::string_view, 4> kTests = {"quasistatic-forward", "quasistatic-reverse",
                                                    "dynamic-forward", "dynamic-reverse"};

/// Where the values of a motor and its test's state stand in a file.
struct Places {
  std::size_t time = 0, state = 0;
  std::array<std::size_t, kValues.size()> values{};
};

/// Behind the last slash: entries are shown as NT:/DataLog/voltage-MOTOR-TEST.
std::string_view entry_of(std::string_view column) {
  const std::size_t slash = column.rfind('/');
  return slash == std::string_view::npos ? column : column.substr(slash + 1);
}

/// MOTOR-TEST of "voltage-MOTOR-TEST".
std::optional<std::string> motor_of(std::string_view column, std::string_view value) {
  const std::string_view entry = entry_of(column);
  if (entry.size() <= value.size() + 1 || !entry.starts_with(value) || entry[value.size()] != '-')
    return std::nullopt;
  return std::string(entry.substr(value.size() + 1));
}

/// The motors that have all values, and where.
std::map<std::string, Places> motors_of(const io::CsvReader& csv) {
  std::map<std::string, Places> motors;
  std::map<std::string, std::size_t> seen;
  for (std::size_t value = 0; value < kValues.size(); ++value) {
    for (std::size_t i = 0; i < csv.header().size(); ++i) {
      const auto motor = motor_of(csv.header()[i], kValues[value]);
      if (!motor) continue;
      motors[*motor].values[value] = i;
      ++seen[*motor];
    }
  }
  std::erase_if(motors, [&](const auto& motor) { return seen[motor.first] != kValues.size(); });
  return motors;
}

Places motor_asked_for(const io::CsvReader& csv, const std::string& joint) {
  const std::map<std::string, Places> motors = motors_of(csv);
  std::vector<std::string> names, fitting;
  for (const auto& [name, places] : motors) {
    names.push_back(name);
    if (joint.empty() || name == joint || name.starts_with(joint + "-")) fitting.push_back(name);
  }
  if (names.empty()) {
    io::refuse(csv.file(),
               "no motor has voltage-MOTOR-TEST, position-MOTOR-TEST and velocity-MOTOR-TEST, as "
               "SysIdRoutineLog names them; with other names, state the columns in a rig");
  }
  if (fitting.size() == 1) return motors.at(fitting.front());
  io::refuse(csv.file(),
             fmt::format("{}; say --joint, one of {}",
                         fitting.empty() ? "has no motor " + joint : "holds several motors",
                         io::listed(names)));
}

Places places_of(const io::CsvReader& csv, const std::string& joint) {
  const auto time = csv.find("Timestamp");
  if (!time) io::refuse(csv.file(), "has no column Timestamp, as an exported table has");
  if (csv.find("Key") && csv.find("Value")) {
    io::refuse(csv.file(), "is a list of single values; export \"CSV (Table)\"");
  }
  Places places = motor_asked_for(csv, joint);
  places.time = *time;
  for (std::size_t i = 0; i < csv.header().size(); ++i) {
    const std::string_view entry = entry_of(csv.header()[i]);
    if (!entry.starts_with("sysid-test-state") && entry != "SysIdTestState") continue;
    if (places.state != 0) io::refuse(csv.file(), "holds two states of tests; export one routine");
    places.state = i;
  }
  if (places.state == 0) {
    io::refuse(csv.file(), "has no sysid-test-state-TEST, which says where a test begins and ends");
  }
  return places;
}

/// Rows become samples, and samples runs: one for each test, by the state's changes.
class Samples {
 public:
  Samples(io::CsvReader& csv, const Places& places, ImportedLog& log)
      : csv_(csv), places_(places), log_(log) {}

  void read() {
    while (csv_.next()) take_row();
    keep_sample();
  }

 private:
  void take_row() {
    const double time_s = csv_.number(places_.time);
    const std::string state(csv_.text(places_.state));
    if (time_s - began_s_ > kOneLoop_s || state != state_) {
      keep_sample();
      began_s_ = time_s;
    }
    enter(state);
    if (!is_test_) return;
    sample_ = {std::string(csv_.text(places_.time))};
    for (const std::size_t place : places_.values) {
      if (csv_.text(place) == "null") {  // Nothing has been appended yet.
        sample_.clear();
        return;
      }
      csv_.number(place);
      sample_.emplace_back(csv_.text(place));
    }
  }

  void enter(const std::string& state) {
    if (state == state_) return;
    state_ = state;
    is_test_ = std::find(kTests.begin(), kTests.end(), state) != kTests.end();
    if (!is_test_ && state != "none" && state != "null" && !state.empty()) {
      csv_.refuse(places_.state, fmt::format("\"{}\" is no state of a test; there are {} and none",
                                             state, io::listed({kTests.begin(), kTests.end()})));
    }
    if (!is_test_) return;
    const int nth = ++tests_[state];
    log_.runs.push_back({nth == 1 ? state : fmt::format("{} {}", state, nth), {}});
  }

  /// Other entries of the same log make rows in which nothing of this motor is new.
  void keep_sample() {
    if (sample_.empty()) return;
    auto& rows = log_.runs.back().rows;
    const bool is_held =
        !rows.empty() && std::equal(sample_.begin() + 1, sample_.end(), rows.back().begin() + 1);
    if (!is_held) rows.push_back(sample_);
    sample_.clear();
  }

  io::CsvReader& csv_;
  const Places& places_;
  ImportedLog& log_;
  std::string state_;
  bool is_test_ = false;
  double began_s_ = -1e300;
  std::vector<std::string> sample_;
  std::map<std::string, int> tests_;
};

const PositionUnit& unit_asked_for(const ImportRequest& request) {
  const PositionUnit* unit = find_position_unit(request.units);
  if (unit != nullptr) return *unit;
  io::refuse("--units",
             fmt::format("{}; a CSV does not say what positions are in; known are {}",
                         request.units.empty() ? "is needed"
                                               : "\"" + request.units + "\" is not a known unit",
                         position_unit_names()));
}

ImportedLog read_sysid_csv(const ImportRequest& request) {
  ImportedLog log;
  set_sysid_columns(unit_asked_for(request), 1.0, log);
  for (const std::filesystem::path& path : request.files) {
    io::CsvReader csv(path, io::CsvReader::CutEnd::kDropped);
    const Places places = places_of(csv, request.joint);
    const std::size_t before = log.runs.size();
    Samples(csv, places, log).read();
    if (log.runs.size() == before) io::refuse(csv.file(), "no row is in a test");
    if (request.files.size() == 1) continue;
    for (std::size_t i = before; i < log.runs.size(); ++i) {
      log.runs[i].name = io::stem_in_text(path) + " " + log.runs[i].name;
    }
  }
  log.notes.emplace_back(
      "rows within 2 ms are one sample, rows in which nothing is new are left out; the voltage is "
      "taken for the winding's, the position for the output's");
  return log;
}

}  // namespace

const Importer sysid_csv = {"sysid_csv",
                            "CSV table exported from a WPILib data log with SysIdRoutine's entries",
                            "https://github.com/wpilibsuite/allwpilib: SysIdRoutineLog; "
                            "https://docs.advantagescope.org/more-features/export",
                            read_sysid_csv,
                            true,
                            true};

}  // namespace torquewright::identification::imports
