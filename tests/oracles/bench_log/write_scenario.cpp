// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <system_error>

#include "io/files/atomic_file.hpp"
#include "tests/oracles/bench_log/documents.hpp"

namespace torquewright::oracles {
namespace {

void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 10);
  text.append(digits.data(), end.ptr);
}

void append_run(std::string& text, const MeasuredLog& log, const LogRun& run, bool names_run) {
  for (std::size_t row = 0; row < run.columns.front().size(); ++row) {
    for (std::size_t c = 0; c < log.columns.size(); ++c) {
      if (c != 0) text += ',';
      append_number(text, run.columns[c][row]);
    }
    if (names_run) text += ',' + run.name;
    text += '\n';
  }
}

std::string header(const MeasuredLog& log, bool names_run) {
  std::string text;
  for (const std::string& column : log.columns) text += (text.empty() ? "" : ",") + column;
  return text + (names_run ? ",run\n" : "\n");
}

}  // namespace

ScenarioFiles write_scenario(const std::filesystem::path& folder, const Scenario& scenario) {
  std::filesystem::create_directories(folder);
  ScenarioFiles files{{}, folder / "rig.json", folder / "actuator.json", folder / "truth.json"};
  io::write_whole_file(files.rig, scenario.rig.dump(1) + "\n");
  io::write_whole_file(files.actuator, scenario.actuator.dump(1) + "\n");
  io::write_whole_file(files.truth, truth_document(scenario).dump(1) + "\n");
  std::string all = header(scenario.log, true);
  for (const LogRun& run : scenario.log.runs) {
    if (scenario.one_file) {
      append_run(all, scenario.log, run, true);
      continue;
    }
    std::string text = header(scenario.log, false);
    append_run(text, scenario.log, run, false);
    files.logs.push_back(folder / (run.name + ".csv"));
    io::write_whole_file(files.logs.back(), text);
  }
  if (scenario.one_file) {
    files.logs.push_back(folder / "log.csv");
    io::write_whole_file(files.logs.back(), all);
  }
  return files;
}

}  // namespace torquewright::oracles
