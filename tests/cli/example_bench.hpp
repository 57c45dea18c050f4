// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/cli/workplace.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::cli_test {

/// A folder with a bench, the example's or a drawn one: logs, rig.json, actuator.json.
struct Bench {
  Workplace place;
  std::vector<std::string> logs{"log.csv"};

  Bench() {
    for (const auto& [name, file] : {std::pair{"log.csv", "specs/log/bench_as_built.csv"},
                                     std::pair{"rig.json", "specs/log/bench_rig.json"},
                                     std::pair{"actuator.json", "specs/log/bench_actuator.json"}}) {
      place.write(name, text_of(in_repository(file)));
    }
  }
  explicit Bench(const oracles::Scenario& scenario) {
    logs.clear();
    for (const auto& log : oracles::write_scenario(place.path(), scenario).logs) {
      logs.push_back(log.filename());
    }
  }

  /// The command's words with the logs, rig and actuator, and what follows them.
  Outcome run(std::vector<std::string> command, const std::vector<std::string>& more = {}) const {
    command.insert(command.end(), logs.begin(), logs.end());
    for (const char* word : {"--rig", "rig.json", "--actuator", "actuator.json"}) {
      command.emplace_back(word);
    }
    command.insert(command.end(), more.begin(), more.end());
    return place.run(command);
  }
};

}  // namespace torquewright::cli_test
