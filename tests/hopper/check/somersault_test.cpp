// SPDX-License-Identifier: Apache-2.0
// A ballistic somersault with a closed form. A trunk of inertia I carries two equal masses m that
// slide out on either side to r(t); then CAM is L at all times, CAV is w(t) = L / (I + 2 m r^2),
// and the slides push with m (r'' - r w^2). Here w(t) = w0 + k t, so that r(t) follows in closed
// form.
#include <gtest/gtest.h>

#include <cmath>

#include "hopper/check/hopper_check.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kTrunk_kg = 5;
constexpr double kTrunk_kg_m2 = 0.3;
constexpr double kMass_kg = 2;
constexpr double kMomentum = 6;  // Nm s
constexpr double kFirst_rad_s = 7.4;
constexpr double kGain_rad_s2 = 6;
constexpr double kGravity = 9.81;

Robot diver() {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kPlanar;
  dynamics::Body trunk;
  trunk.name = "trunk";
  trunk.inertia = {kTrunk_kg, Eigen::Vector3d::Zero(), kTrunk_kg_m2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies.push_back(trunk);
  for (const double side : {1.0, -1.0}) {
    dynamics::Body mass;
    mass.name = side > 0 ? "front" : "rear";
    mass.joint.name = mass.name;
    mass.joint.kind = dynamics::JointKind::kPrismatic;
    mass.joint.axis = Eigen::Vector3d(side, 0, 0);
    mass.inertia.mass_kg = kMass_kg;
    robot.tree.bodies.push_back(mass);
  }
  robot.contacts.push_back({"nose", {0, {0, 0, -0.1}}, 0.5, 0.0});
  return robot;
}

double turning(double t) { return kFirst_rad_s + kGain_rad_s2 * t; }

/// r, r', r'' from 2 m r^2 = L/w - I.
Eigen::Vector3d reach(double t) {
  const double w = turning(t);
  const double k = kGain_rad_s2;
  const double r = std::sqrt((kMomentum / w - kTrunk_kg_m2) / (2 * kMass_kg));
  const double square_rate = -kMomentum * k / (w * w) / (2 * kMass_kg);              // (r^2)'
  const double square_curve = 2 * kMomentum * k * k / (w * w * w) / (2 * kMass_kg);  // (r^2)''
  const double rate = square_rate / (2 * r);
  return {r, rate, (square_curve - 2 * rate * rate) / (2 * r)};
}

Motion somersault(const Robot& robot) {
  Motion motion;
  for (int i = 0; i <= 500; ++i) motion.times_s.push_back(1e-3 * i);
  const Index samples = motion.samples();
  motion.positions.resize(5, samples);
  motion.velocities.resize(5, samples);
  motion.accelerations.resize(5, samples);
  motion.efforts.setZero(2, samples);
  motion.has_effort = {false, false};
  for (Index i = 0; i < samples; ++i) {
    const double t = motion.time_s(i);
    const Eigen::Vector3d r = reach(t);
    motion.positions.col(i) << 0.5 * t, 1 + 3 * t - 0.5 * kGravity * t * t,
        kFirst_rad_s * t + 0.5 * kGain_rad_s2 * t * t, r[0], r[0];
    motion.velocities.col(i) << 0.5, 3 - kGravity * t, turning(t), r[1], r[1];
    motion.accelerations.col(i) << 0, -kGravity, kGain_rad_s2, r[2], r[2];
  }
  (void)robot;
  return motion;
}

TEST(Somersault, KeepsItsMomentumWhileItTucks) {
  const Robot robot = diver();
  Motion motion = somersault(robot);
  const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
  const Demand demand = demand_of(robot, motion, contacts);
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    EXPECT_LE((demand.angular_momentum_Nm_s.col(i) - Eigen::Vector3d(0, kMomentum, 0)).norm(),
              1e-12);
    EXPECT_NEAR(demand.angular_velocity_rad_s(1, i), turning(t), 1e-12);
    EXPECT_NEAR(demand.lateral_inertia_kg_m2(0, i) * turning(t), kMomentum, 1e-12);
    const Eigen::Vector3d r = reach(t);
    const double push_N = kMass_kg * (r[2] - r[0] * turning(t) * turning(t));
    EXPECT_NEAR(demand.joint_effort(0, i), push_N, 1e-10);
    EXPECT_NEAR(demand.joint_effort(1, i), push_N, 1e-10);
    EXPECT_LE(demand.residual.col(i).head(3).norm(), 1e-10);
  }
  const CheckOptions options;
  const auto found = flights({robot, options, motion, contacts, demand});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].take_off_rad_s, 7.4, 1e-12);
  EXPECT_NEAR(found[0].peak_rad_s, 10.4, 1e-12);
  EXPECT_NEAR(found[0].angular_momentum_Nm_s, 6, 1e-12);
  EXPECT_LE(found[0].angular_momentum_drift_Nm_s, 1e-12);
  EXPECT_NEAR(found[0].rise_m, 3 * 0.306 - 0.5 * kGravity * 0.306 * 0.306, 1e-6);
}

// The same without rates: slopes and curvatures are of second order in the step.
TEST(Somersault, IsFoundFromPositionsAlone) {
  const Robot robot = diver();
  Motion motion = somersault(robot);
  motion.velocity_origin = Origin::kAbsent;
  motion.acceleration_origin = Origin::kAbsent;
  const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
  const Demand demand = demand_of(robot, motion, contacts);
  for (Index i = 1; i + 1 < motion.samples(); ++i) {
    EXPECT_NEAR(demand.angular_momentum_Nm_s(1, i), kMomentum, 2e-4);
    EXPECT_LE(demand.residual.col(i).head(3).norm(), 2e-2);
  }
}

// A body that falls too slowly is held by something: that is no motion.
TEST(Somersault, ThatFloatsIsRefusedWithTimeAndSize) {
  Robot robot = diver();
  Motion motion = somersault(robot);
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    motion.positions(1, i) += 0.25 * kGravity * t * t;
    motion.velocities(1, i) += 0.5 * kGravity * t;
    motion.accelerations(1, i) += 0.5 * kGravity;
  }
  motion.file = "floats.csv";
  CheckOptions options;
  try {
    check_motion(robot, motion, options);
    FAIL() << "was accepted";
  } catch (const io::SpecError& error) {
    // Half of the weight of 9 kg.
    EXPECT_NE(std::string(error.what()).find("44.1"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("floats.csv"), std::string::npos);
  }
  // Nor is a single instant of it, which has no duration to average over, or a few ms.
  for (const Index samples : {1, 4}) {
    Motion part = motion;
    part.times_s.resize(static_cast<std::size_t>(samples));
    for (Eigen::MatrixXd* table : {&part.positions, &part.velocities, &part.accelerations}) {
      *table = table->leftCols(samples).eval();
    }
    EXPECT_THROW(check_motion(robot, part, options), io::SpecError) << samples;
  }
}

}  // namespace
}  // namespace torquewright::hopper
