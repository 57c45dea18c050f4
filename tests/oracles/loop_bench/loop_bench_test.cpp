// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracles/loop_bench/draws.hpp"
#include "tests/oracles/loop_bench/situation.hpp"

namespace torquewright::oracles::loop {
namespace {

Rig two_links() {
  Rig rig;
  rig.shape = "arm";
  rig.links = {{2.0, 0.4, 0.17, 0.03}, {1.1, 0.3, 0.16, 0.012}};
  rig.drives.resize(2);
  return rig;
}

/// Of the links alone: kinetic energy by their mass matrix, and their height.
double energy_J(const Rig& rig, const Pair& q, const Pair& v) {
  const LinkTorques at = link_torques(rig, q, v);
  const Link &a = rig.links[0], &b = rig.links[1];
  const double height =
      -a.mass_kg * a.center_m * std::cos(q[0]) -
      b.mass_kg * (a.length_m * std::cos(q[0]) + b.center_m * std::cos(q[0] + q[1]));
  return 0.5 * (at.m11 * v[0] * v[0] + 2.0 * at.m12 * v[0] * v[1] + at.m22 * v[1] * v[1]) +
         kGravity_m_s2 * height;
}

// Oracle: what the torques do is what the energy gains, whatever the accelerations are.
TEST(LoopBench, TorquesOfTheLinksDoTheWorkThatTheirEnergyGains) {
  const Rig rig = two_links();
  Draws draws(5);
  constexpr double kStep_s = 1e-6;
  for (int trial = 0; trial < 20; ++trial) {
    Pair q{}, v{}, a{};
    for (std::size_t j = 0; j < 2; ++j) {
      q[j] = draws.uniform(-3.0, 3.0);
      v[j] = draws.uniform(-4.0, 4.0);
      a[j] = draws.uniform(-20.0, 20.0);
    }
    const auto after = [&](double s) {
      return energy_J(rig,
                      {q[0] + s * v[0] + 0.5 * s * s * a[0], q[1] + s * v[1] + 0.5 * s * s * a[1]},
                      {v[0] + s * a[0], v[1] + s * a[1]});
    };
    const LinkTorques at = link_torques(rig, q, v);
    const double power_W = v[0] * (at.m11 * a[0] + at.m12 * a[1] + at.bias_Nm[0]) +
                           v[1] * (at.m12 * a[0] + at.m22 * a[1] + at.bias_Nm[1]);
    const double gained_W = (after(kStep_s) - after(-kStep_s)) / (2.0 * kStep_s);
    EXPECT_NEAR(gained_W, power_W, 1e-6 * std::max(1.0, std::abs(power_W)));
  }
}

// Oracle: statics. A joint that is held against its own friction takes any torque up to it and
// stays.
TEST(LoopBench, DryFrictionHoldsUpToItsLevelAndSlidesBeyond) {
  Rig rig;
  rig.shape = "flywheel";
  rig.links = {{0.0, 0.0, 0.0, 0.05}};
  rig.drives.resize(1);
  rig.drives[0].peak_current_A = 100.0;
  rig.drives[0].stated = {{"coulomb_friction", {{"coulomb_Nm", 1.0}}}};
  Loop loop;
  loop.stiffness_Nm_rad = {5.0};
  loop.damping_Nm_s_rad = {1.0};
  loop::Run run{1.0, {Reference{}}};
  run.references[0].waves = {{0.15, 2.0, 0.0}};  // 0.75 Nm and, a quarter later, 0.3 Nm
  const auto held = moved(rig, loop, run);
  EXPECT_NEAR(held.back().position_rad[0], held.front().position_rad[0], 1e-15);  // rounding
  run.references[0].waves = {{1.0, 2.0, 0.0}};
  EXPECT_GT(moved(rig, loop, run).back().position_rad[0], 0.3);
}

// Oracle: the same seed makes the same log; sizes are what they are said to be.
TEST(LoopBench, AHiddenLawIsOneToThreeHundredFloorsAndIsInTheLog) {
  const Made one = made("one", 4), again = made("one", 4);
  ASSERT_EQ(one.size_floors.size(), 1U);
  EXPECT_GE(one.size_floors[0], 1.0);
  EXPECT_LE(one.size_floors[0], 300.0);
  EXPECT_TRUE(one.is_recoverable[0]);
  ASSERT_EQ(one.records.size(), again.records.size());
  for (std::size_t run = 0; run < one.records.size(); ++run)
    EXPECT_EQ(one.records[run].back().joints[0].current_A,
              again.records[run].back().joints[0].current_A);
}

/// Currents that are logged in the first run where this is what is hidden.
std::vector<double> currents_A(Situation it, const std::vector<Law>& hidden, double offset_A) {
  it.rig.drives[0].hidden = hidden;
  it.sensing.current_offset_A = offset_A;
  auto states = moved(it.rig, it.loop, it.runs[0]);
  states.erase(states.begin(),
               states.begin() + static_cast<std::ptrdiff_t>(it.runs[0].before_s / kStep_s));
  std::vector<double> currents;
  for (const Row& row : sensed(it.rig, it.sensing, states, 0))
    currents.push_back(row.joints[0].current_A);
  return currents;
}

/// Root of the mean square, over the noise.
double apart_floors(const Situation& it, const std::vector<double>& a,
                    const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size())) / it.sensing.current_noise_A;
}

// Oracle: the other law's own log by the same noise, at thirty floors; a hundredth of one is
// what the loop's period and the settling make of it.
TEST(LoopBench, AnUndecidableLogIsThatOfAnotherLawToo) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Situation it = drawn("undecidable", seed);
    const double per_A = it.rig.drives[0].torque_per_current_Nm_A();
    const double offset_A = 30.0 * it.sensing.current_noise_A, level_Nm = offset_A * per_A;
    const double turning_rad_s = it.runs[0].references[0].turning_rad_s;
    const auto dry = currents_A(it, {{"coulomb_friction", {{"coulomb_Nm", level_Nm}}}}, 0.0);
    EXPECT_LT(apart_floors(it, dry, currents_A(it, {}, offset_A)), 0.01) << seed;
    const Law drag{"viscous_friction", {{"viscous_Nm_s_rad", level_Nm / turning_rad_s}}};
    const double by_drag = apart_floors(it, dry, currents_A(it, {drag}, 0.0));
    if (seed % 2 == 0) {
      EXPECT_LT(by_drag, 0.01) << seed;
    } else {
      EXPECT_GT(by_drag, 1.0) << seed;  // other speeds tell
    }
  }
}

TEST(LoopBench, UnknownClassesAreRefused) {
  EXPECT_THROW((void)drawn("many", 1), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::oracles::loop
