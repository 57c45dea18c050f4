// SPDX-License-Identifier: Apache-2.0
// The loop from a plan to a name: what is played decides what can be told. Oracle: the truth that
// is simulated, a load-dependent friction that the nominal actuator does not declare; the same
// actuator, noise and duration on the plan and on a plain chirp.
#include <gtest/gtest.h>

#include <algorithm>

#include "actuator/effects/library.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "identification/answer/identify.hpp"
#include "identification/experiment/plan.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification::loop_test {
namespace {

constexpr const char* kEffect = "quadratic_drag";
const char* const kActuator = TORQUEWRIGHT_SOURCE_DIR "/specs/log/bench_actuator.json";

Rig bench_rig() {
  return read_rig(io::read_document(TORQUEWRIGHT_SOURCE_DIR "/specs/log/bench_rig.json", "rig"));
}

Identification identified(const std::vector<ExcitationRun>& runs,
                          const std::map<Quantity, double>& noise) {
  actuator::Actuator truth = actuator::read_actuator(kActuator).actuator;
  actuator::Effect drag = actuator::neutral(*actuator::find_effect(kEffect));
  drag.values = {0.01};
  truth.effects.push_back(drag);
  SimulatedLogOptions options;
  options.noise = noise;
  const test::ScratchFolder folder;
  const auto log = folder.write("log.csv", simulated_log(bench_rig(), truth, runs, options));
  return identify({log}, bench_rig(), {{"", actuator::read_actuator(kActuator)}});
}

bool is_certain_of(const Identification& found, const std::string& effect) {
  if (found.verdict == Verdict::kCannotTell) return false;
  for (const NamedEffect& each : found.equations[found.leading].added) {
    if (each.effect == effect) return true;
  }
  return false;
}

TEST(PlannedLog, NamesTheEffectWhereTheChirpsCannot) {
  PlanOptions options;
  options.candidates = 8;
  const Plan plan =
      plan_excitation(bench_rig(), actuator::read_actuator(kActuator).actuator, options);
  const Identification planned = identified(plan.runs, plan.noise);
  EXPECT_EQ(planned.verdict, Verdict::kExplained);
  EXPECT_TRUE(is_certain_of(planned, kEffect));
  const Identification chirped = identified(plan.chirp, plan.noise);
  EXPECT_EQ(chirped.verdict, Verdict::kCannotTell);
  EXPECT_FALSE(is_certain_of(chirped, kEffect));
}

}  // namespace
}  // namespace torquewright::identification::loop_test
