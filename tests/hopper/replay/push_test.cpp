// SPDX-License-Identifier: Apache-2.0
// Pushes in flight, in every engine that is there. Oracles: closed forms of what no drive can
// change. From one row to the next p grows by P + m g dt and L by (r_body - r_mass) x P.
#include "hopper/surroundings/push.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/replay/replay.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

// A step of Runge-Kutta weighs its stages' mass matrices, and bodies move by some 10 m/s times
// 0.1 ms within it: a part in a thousand of what the push makes of the rest, which cancels in sums
// of linear momenta. Of those 1e-9 is rounding of 1e5 N.
constexpr double kLinear_N_s = 1e-9;
constexpr double kArm = 1e-3;  // of |P|, m

struct Hop {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion motion =
      read_motion(robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_hop.csv", {}, {}, {}});
  HopperReport report = check_motion(robot, motion, CheckOptions());

  /// The middle of the flight, where a hundredth of a second to either side is in the air.
  double aloft_s() const {
    const Flight& flight = report.flights.front();
    return 0.5 * (flight.from_s + flight.until_s);
  }
  Record pushed(const EngineKind& engine, const Push& push) {
    ReplayOptions options;
    options.engine = &engine;
    options.run.pushes = {push};
    return Replay(robot, motion, report, options).run({}).record;
  }
};

/// Momentum of a row, and where things are.
struct Moving {
  double mass_kg;
  Vector3d linear_N_s, angular_Nm_s, arm_m;

  Moving(const Robot& robot, const RecordRow& row, std::size_t body) {
    dynamics::TreeState state(robot.tree);
    state.set(row.position, row.velocity);
    const dynamics::Centroid mass = dynamics::centroid(state);
    mass_kg = mass.mass_kg;
    linear_N_s = mass_kg * mass.velocity_m_s;
    angular_Nm_s = mass.angular_momentum_Nm_s;
    const Vector3d own_m = robot.tree.bodies[body].inertia.center_of_mass_m;
    arm_m = dynamics::point_position_m(state, {body, own_m}) - mass.position_m;
  }
};

class PushInFlight : public testing::TestWithParam<const EngineKind*> {
 protected:
  void SetUp() override {
    if (GetParam()->absence == nullptr) return;
    if (const auto absence = GetParam()->absence()) GTEST_SKIP() << *absence;
  }
};

TEST_P(PushInFlight, AddsItsImpulseToTheMomentumAndNothingElse) {
  Hop hop;
  const double gravity_m_s2 = hop.robot.tree.gravity_m_s2;
  const Push pushes[] = {{0, "thigh", {4.0, 0.0, -1.0}, hop.aloft_s()},
                         {1, "calf", {0.0, 1.5, 0.5}, hop.aloft_s() + 0.003}};
  for (const Push& push : pushes) {
    const Record record = hop.pushed(*GetParam(), push);
    std::size_t seen = 0;
    for (std::size_t i = 1; i < record.rows.size(); ++i) {
      const RecordRow &before = record.rows[i - 1], &after = record.rows[i];
      if (std::abs(after.time_s - push.time_s) > 0.01) continue;
      ASSERT_FALSE(after.touches.any());
      const bool is_pushed = before.time_s <= push.time_s && push.time_s < after.time_s;
      const Vector3d impulse_N_s = is_pushed ? push.impulse_N_s : Vector3d(Vector3d::Zero());
      const Moving was(hop.robot, before, push.body), is(hop.robot, after, push.body);
      const Vector3d fall_N_s(0.0, 0.0,
                              -was.mass_kg * gravity_m_s2 * (after.time_s - before.time_s));
      EXPECT_LT((is.linear_N_s - was.linear_N_s - impulse_N_s - fall_N_s).norm(), kLinear_N_s);
      EXPECT_LT((is.angular_Nm_s - was.angular_Nm_s - was.arm_m.cross(impulse_N_s)).norm(),
                1e-9 + kArm * impulse_N_s.norm());
      seen += is_pushed ? 1 : 0;
    }
    EXPECT_EQ(seen, 1u) << push.body_name;
  }
}

INSTANTIATE_TEST_SUITE_P(, PushInFlight, testing::ValuesIn(every_engine()),
                         [](const auto& one) { return std::string(one.param->name); });

}  // namespace
}  // namespace torquewright::hopper
