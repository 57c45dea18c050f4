// SPDX-License-Identifier: Apache-2.0
// What is written is what the contract says a laboratory hands over, and the truth is in it.
#include "tests/oracles/bench_log/scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "io/documents/document.hpp"
#include "io/files/csv.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::oracles {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::set<std::string> named_columns(const nlohmann::json& rig) {
  std::set<std::string> names;
  for (const auto& [column, quantity] : rig.at("columns").items()) names.insert(column);
  if (rig.contains("ignore")) {
    for (const auto& column : rig.at("ignore")) names.insert(column.get<std::string>());
  }
  return names;
}

/// Every document reads, every column is named, and every held-out run exists.
void expect_readable(const Scenario& scenario) {
  const test::ScratchFolder folder;
  const ScenarioFiles files = write_scenario(folder.path() / "scenario", scenario);
  EXPECT_NO_THROW(io::read_document(files.actuator, "actuator")) << scenario.name;
  std::set<std::string> runs;
  for (const LogRun& run : scenario.log.runs) runs.insert(run.name);
  for (const auto& held : scenario.rig.value("holdout_runs", nlohmann::json::array())) {
    EXPECT_TRUE(runs.contains(held.get<std::string>())) << scenario.name;
  }
  std::size_t rows = 0;
  for (const fs::path& log : files.logs) {
    io::CsvReader reader(log);
    const std::set<std::string> columns(reader.header().begin(), reader.header().end());
    EXPECT_EQ(columns, named_columns(scenario.rig)) << scenario.name;
    while (reader.next()) {
      for (std::size_t c = 0; c < scenario.log.columns.size(); ++c) reader.number(c);
      ++rows;
    }
  }
  std::size_t expected = 0;
  for (const LogRun& run : scenario.log.runs) expected += run.columns.front().size();
  EXPECT_EQ(rows, expected);
}

TEST(Scenario, OfEveryClassIsReadable) {
  for (const LogClass log_class : {LogClass::kNone, LogClass::kOne, LogClass::kTwo,
                                   LogClass::kCannotTell, LogClass::kOutside}) {
    for (const std::uint64_t seed : {1U, 4U}) expect_readable(draw(log_class, seed));
  }
}

TEST(Scenario, OfEveryEffectIsReadable) {
  for (std::size_t seed = 0; seed < drawn_effects().size(); ++seed) {
    const Scenario scenario = draw(LogClass::kShort, seed);
    EXPECT_EQ(scenario.truth.effects.at(0).effect, drawn_effects()[seed]);
    EXPECT_EQ(scenario.log.runs.size(), 2U);
    expect_readable(scenario);
  }
}

TEST(Scenario, IsTheSameForTheSameSeed) {
  const test::ScratchFolder folder;
  for (const char* name : {"a", "b"}) {
    write_scenario(folder.path() / name, draw(LogClass::kShort, 30));
  }
  write_scenario(folder.path() / "c", draw(LogClass::kShort, 30 + drawn_effects().size()));
  for (const char* file : {"rig.json", "actuator.json", "truth.json"}) {
    EXPECT_EQ(text_of(folder.path() / "a" / file), text_of(folder.path() / "b" / file));
  }
  for (const auto& entry : fs::directory_iterator(folder.path() / "a")) {
    EXPECT_EQ(text_of(entry.path()), text_of(folder.path() / "b" / entry.path().filename()));
  }
  EXPECT_NE(text_of(folder.path() / "a" / "actuator.json"),
            text_of(folder.path() / "c" / "actuator.json"));
}

TEST(Scenario, HidesTheTruthFromTheDocuments) {
  for (std::size_t seed = 0; seed < drawn_effects().size(); ++seed) {
    const Scenario scenario = draw(LogClass::kShort, seed);
    for (const auto& declared : scenario.actuator.at("effects")) {
      EXPECT_NE(declared.at("effect"), drawn_effects()[seed]);
    }
  }
}

TEST(Scenario, HasEffectsOfTwoToTenNoiseFloors) {
  for (const LogClass log_class : {LogClass::kShort, LogClass::kTwo}) {
    for (std::uint64_t seed = 0; seed < 20; seed += log_class == LogClass::kTwo ? 4 : 1) {
      const Scenario scenario = draw(log_class, seed);
      for (const TrueEffect& effect : scenario.truth.effects) {
        // 5 % is what the dial is turned to; of two, the second may have turned the noise.
        EXPECT_GT(effect.noise_multiple, 2.0 * 0.94) << scenario.name << ' ' << effect.effect;
        EXPECT_LT(effect.noise_multiple, 10.0 * 1.06) << scenario.name << ' ' << effect.effect;
      }
    }
  }
}

TEST(Scenario, RefusesAnEffectThatTheContractLacks) {
  EXPECT_THROW(draw_effect("gremlins", 1), std::invalid_argument);
}

TEST(Sources, UseNothingThatTheyJudge) {
  const fs::path folder = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/oracles/bench_log";
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() == "scenario_test.cpp") continue;
    const std::string text = text_of(entry.path());
    for (const char* judged : {"actuator/", "identification/", "gearbox/", "dynamics/"}) {
      EXPECT_EQ(text.find(std::string("#include \"") + judged), std::string::npos) << entry.path();
    }
  }
}

}  // namespace
}  // namespace torquewright::oracles
