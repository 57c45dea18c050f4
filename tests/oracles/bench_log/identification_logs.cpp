// SPDX-License-Identifier: Apache-2.0
// Writes scenarios of tests/oracles/bench_log into folders, to be looked at or played by hand.
#include <chrono>
#include <cstdio>
#include <map>
#include <string>

#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace {

using torquewright::oracles::LogClass;

const std::map<std::string, LogClass> kClasses{
    {"none", LogClass::kNone},       {"one", LogClass::kOne},
    {"two", LogClass::kTwo},         {"cannot_tell", LogClass::kCannotTell},
    {"outside", LogClass::kOutside}, {"short", LogClass::kShort}};

struct Options {
  std::string folder;
  std::string log_class = "one";
  std::string effect;
  std::uint64_t seed = 1;
  int count = 1;
};

void write_all(const Options& options) {
  using namespace torquewright::oracles;
  for (int k = 0; k < options.count; ++k) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
    const auto start = std::chrono::steady_clock::now();
    const Scenario scenario = options.effect.empty() ? draw(kClasses.at(options.log_class), seed)
                                                     : draw_effect(options.effect, seed);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (!options.folder.empty()) {
      write_scenario(
          options.folder + "/" + name_of(scenario.truth.log_class) + "_" + std::to_string(seed),
          scenario);
    }
    std::printf("%-60s %.3f s", scenario.name.c_str(), took.count());
    for (const TrueEffect& effect : scenario.truth.effects) {
      std::printf("  %.2f floors", effect.noise_multiple);
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace torquewright;
  Options options;
  command_line::Program program("identification_logs", "Measured logs with a known truth");
  command_line::Command& top = program.top();
  top.add_option("--into", options.folder, "Folder; without it nothing is written");
  top.add_option("--class", options.log_class, "Of the truth")
      .one_of({"none", "one", "two", "cannot_tell", "outside", "short"});
  top.add_option("--effect", options.effect, "This one, in place of --class");
  top.add_option("--seed", options.seed, "Of the first log");
  top.add_option("--count", options.count, "Seeds in a row");
  top.works([&] {
    write_all(options);
    return cli::ExitCode::kPasses;
  });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}
