// SPDX-License-Identifier: Apache-2.0
// Writes scenarios of tests/oracles/bench_log into folders, to be looked at or played by hand.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <map>

#include "tests/oracles/bench_log/scenario.hpp"

namespace {

using torquewright::oracles::LogClass;

struct Options {
  std::string folder;
  LogClass log_class = LogClass::kOne;
  std::string effect;
  std::uint64_t seed = 1;
  int count = 1;
};

void write_all(const Options& options) {
  using namespace torquewright::oracles;
  for (int k = 0; k < options.count; ++k) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
    const auto start = std::chrono::steady_clock::now();
    const Scenario scenario =
        options.effect.empty() ? draw(options.log_class, seed) : draw_effect(options.effect, seed);
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
  CLI::App app("Measured logs with a known truth");
  Options options;
  const std::map<std::string, LogClass> classes{
      {"none", LogClass::kNone},       {"one", LogClass::kOne},
      {"two", LogClass::kTwo},         {"cannot_tell", LogClass::kCannotTell},
      {"outside", LogClass::kOutside}, {"short", LogClass::kShort}};
  app.add_option("--into", options.folder, "Folder; without it nothing is written");
  app.add_option("--class", options.log_class)->transform(CLI::CheckedTransformer(classes));
  app.add_option("--effect", options.effect, "This one, in place of --class");
  app.add_option("--seed", options.seed);
  app.add_option("--count", options.count, "Seeds in a row");
  CLI11_PARSE(app, argc, argv);
  write_all(options);
  return 0;
}
