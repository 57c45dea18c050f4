// SPDX-License-Identifier: Apache-2.0
// Logs of the sampled bench, a generator that shares no code with what is tested, that were read
// wrongly once. Oracle: the truth that it put in, here by its seeds' documents.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "identification/answer/identify.hpp"
#include "io/documents/document.hpp"
#include "tests/oracles/sampled_bench/documents.hpp"

namespace torquewright::rates {
namespace {

using identification::Identification;
using identification::NamedEffect;

/// The two effects of the seed, looked for among these names; empty: among all.
Identification identified(std::uint64_t seed, std::vector<std::string> names) {
  const auto folder = std::filesystem::path(testing::TempDir()) / fmt::format("sampled_{}", seed);
  oracles::sampled::write_bench(oracles::sampled::draw_bench("two", seed), folder);
  const auto rig = identification::read_rig(io::read_document(folder / "rig.json", "rig"));
  identification::IdentifyOptions options;
  options.analysis.only = std::move(names);
  Identification found =
      identification::identify({folder / "log.csv"}, rig,
                               {{"", actuator::read_actuator(folder / "actuator.json")}}, options);
  std::filesystem::remove_all(folder);
  return found;
}

// One run of seven creeps, and it was the fifth: of the last three, which are held out, it alone
// shows what nothing that is fitted does. 0.3675, 1.5751 Nm and 1.481 rad/s were put in.
TEST(SampledLogs, ARunThatAloneShowsTheLawIsFitted) {
  const Identification found =
      identified(5007, {"coulomb_friction", "stribeck_friction", "viscous_friction"});
  const auto& torque = found.equations.front();
  const auto stribeck =
      std::find_if(torque.added.begin(), torque.added.end(),
                   [](const NamedEffect& each) { return each.effect == "stribeck_friction"; });
  ASSERT_NE(stribeck, torque.added.end());
  for (const auto& [name, truth] : {std::pair{"coulomb_Nm", 0.367482},
                                    {"breakaway_Nm", 1.575124},
                                    {"stribeck_velocity_rad_s", 1.481361}}) {
    EXPECT_NEAR(stribeck->parameters.value(name, NAN), truth,
                3.0 * stribeck->parameters.standard_error(name))
        << name;
  }
  EXPECT_LT(torque.after.holdout_rms, 0.2 * torque.before.holdout_rms);
}

// Gravity and friction under load are all that is missing; two waves of the motor, 0.11 Nm rms of
// which 0.003 pass the band, took what these leave at reversals.
TEST(SampledLogs, WavesThatHardlyShowAreNotCertain) {
  const Identification found = identified(5012, {});
  std::set<std::string> certain;
  for (const NamedEffect* each : certain_of(found.equations.front())) certain.insert(each->effect);
  EXPECT_EQ(certain, (std::set<std::string>{"gravity_imbalance", "load_dependent_friction"}));
}

// Asked for no more than these, the same log has a ripple of 0.018 +- 0.013 of the load.
TEST(SampledLogs, WavesWithinTheirErrorsAreNotCertain) {
  const Identification found = identified(
      5012, {"gravity_imbalance", "load_dependent_friction", "cogging_torque", "gear_ripple"});
  for (const NamedEffect& each : found.equations.front().added) {
    EXPECT_EQ(is_certain(found.equations.front(), each.effect), each.parameters.waves.empty())
        << each.effect;
  }
}

}  // namespace
}  // namespace torquewright::rates
