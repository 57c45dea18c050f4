// SPDX-License-Identifier: Apache-2.0
// Oracles: the documents' own figures, added up by hand; and what a robot is made of, spoilt one
// thing at a time, for which the refusal must name that thing.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "hopper/planning/plane/stance.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using test::documented_robot;
using test::leg_with_tail;

TEST(Plane, TakesTheHopper) {
  const SagittalRobot plane = sagittal(documented_robot("hopper"));
  EXPECT_EQ(plane.robot.tree.base, dynamics::BaseKind::kPlanar);
  EXPECT_NEAR(plane.mass_kg, 7.6 + 3.89 + 0.05 + 0.91, 1e-12);
  // Knee and ankle pitch move, ankle roll (the third joint) is held.
  EXPECT_EQ(plane.moving, (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(plane.held, (std::vector<Index>{5}));
  EXPECT_EQ(plane.directions, (std::vector<double>{1, 1}));
  EXPECT_EQ(plane.robot.tree.bodies[plane.foot].name, "foot");
  EXPECT_EQ(plane.drive_count(), 3u);
  ASSERT_EQ(plane.sole.size(), 2u);
  EXPECT_EQ(plane.sole[0].name, "heel");
  EXPECT_EQ(plane.sole[0].members, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(plane.sole[0].point.p_B_m.isApprox(Vector3d(-0.08, 0, -0.08)));
  EXPECT_EQ(plane.sole[1].name, "toe");
  EXPECT_EQ(plane.sole[1].members, (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(plane.sole[1].point.p_B_m.isApprox(Vector3d(0.12, 0, -0.08)));
}

TEST(Plane, TakesTheLegOnAPoint) {
  const SagittalRobot plane = sagittal(documented_robot("planar_leg"));
  EXPECT_NEAR(plane.mass_kg, 3.3 + 0.634 + 0.064, 1e-12);
  EXPECT_EQ(plane.moving_count(), 5);
  EXPECT_TRUE(plane.held.empty());
  ASSERT_EQ(plane.sole.size(), 1u);
  EXPECT_EQ(plane.sole[0].name, "foot");
}

TEST(Plane, KnowsWhatCarriesTheFootAndWhichWayItTurns) {
  const SagittalRobot plane = sagittal(leg_with_tail());
  EXPECT_EQ(plane.joints, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(plane.directions, (std::vector<double>{-1, 1, 0}));
  EXPECT_EQ(plane.held, (std::vector<Index>{6}));
  ASSERT_EQ(plane.sole.size(), 2u);
  EXPECT_EQ(plane.sole[0].members, (std::vector<std::size_t>{1}));  // The heel was stated last.
}

TEST(Plane, TakesTheLeastFrictionOfPointsThatAreOne) {
  Robot robot = documented_robot("hopper");
  robot.contacts[1].friction_coefficient = 0.3;
  const SagittalRobot plane = sagittal(robot);
  EXPECT_EQ(plane.sole[0].friction_coefficient, 0.3);
  EXPECT_EQ(plane.sole[1].friction_coefficient, 0.6);
}

TEST(Plane, PutsPointsOfAFootBesideThePlaneIntoIt) {
  // The foot's frame 3 cm to the left, everything in it 3 cm to the right: the same robot.
  Robot robot = documented_robot("hopper");
  dynamics::Body& foot = robot.tree.bodies[3];
  const Vector3d beside_m(0, 0.03, 0);
  foot.joint.p_PB_m += beside_m;
  foot.inertia.center_of_mass_m -= beside_m;
  for (ContactPoint& contact : robot.contacts) contact.point.p_B_m -= beside_m;
  const SagittalRobot plane = sagittal(robot);
  EXPECT_TRUE(plane.sole[0].point.p_B_m.isApprox(Vector3d(-0.08, -0.03, -0.08)));
}

TEST(Plane, FillsRowsOfWhatIsHeldWithZeros) {
  const SagittalRobot plane = sagittal(leg_with_tail());
  Eigen::VectorXd moving(6);
  moving << 1, 2, 3, 4, 5, 6;
  Eigen::VectorXd all(7);
  all << 1, 2, 3, 4, 5, 6, 0;
  EXPECT_EQ(plane.all_rows(moving), all);
}

struct Spoilt {
  const char* name;
  const char* robot;
  std::function<void(Robot& robot)> spoil;
  std::vector<const char*> says;
};

std::ostream& operator<<(std::ostream& out, const Spoilt& one) { return out << one.name; }

/// By the hopper's ankle, its left rod one of another length of crank: 5 cm instead of 6.
void shorten_left_crank(Robot& robot) {
  for (Drivetrain& drivetrain : robot.drivetrains) {
    const auto* ankle = dynamic_cast<const ParallelAnkle*>(drivetrain.mechanism.get());
    if (ankle == nullptr) continue;
    ParallelAnkleGeometry geometry = ankle->geometry();
    geometry.rods[0].crank_m *= 5.0 / 6.0;
    drivetrain.mechanism = std::make_shared<ParallelAnkle>(geometry);
  }
}

std::vector<Spoilt> every_fault() {
  return {{"FixedBase",
           "hopper",
           [](Robot& r) { r.tree.base = dynamics::BaseKind::kFixed; },
           {"its base is fixed"}},
          {"NoGravity", "hopper", [](Robot& r) { r.tree.gravity_m_s2 = 0; }, {"gravity is 0 m/s2"}},
          {"NoContacts", "hopper", [](Robot& r) { r.contacts.clear(); }, {"no contact points"}},
          {"TwoFeet",
           "hopper",
           [](Robot& r) { r.contacts[3].point.body = 1; },
           {"it stands on 2 bodies (foot, calf)", "one leg under a base of its own"}},
          {"BallOfAFoot",
           "hopper",
           [](Robot& r) { r.contacts[2].radius_m = 0.01; },
           {"'toe_left' is a ball", "put it 0.01 m lower"}},
          {"HeelToOneSide",
           "hopper",
           [](Robot& r) { r.contacts[0].point.p_B_m.y() = 0.06; },
           {"at its heel", "not mirror images", "0.01 m"}},
          {"ToeOnOneSideOnly", "hopper", [](Robot& r) { r.contacts.pop_back(); }, {"at its toe"}},
          {"ToeHigherThanHeel",
           "hopper",
           [](Robot& r) {
             for (std::size_t i : {2, 3}) r.contacts[i].point.p_B_m.z() = -0.07;
           },
           {"not level", "0.01 m"}},
          {"BulgeBetweenHeelAndToe",
           "hopper",
           [](Robot& r) {
             ContactPoint bulge = r.contacts[0];
             bulge.point.p_B_m = {0.0, 0.0, -0.09};
             r.contacts.push_back(bulge);
           },
           {"at its sole 1 are lower"}},
          {"FootTurnedInItsJoint",
           "hopper",
           [](Robot& r) {
             r.tree.bodies[3].joint.R_PB =
                 Eigen::AngleAxisd(0.1, Vector3d::UnitY()).toRotationMatrix();
           },
           {"the frame of 'foot' is turned"}},
          // 7.6 kg by 1 cm, over 12.45 kg.
          {"MassBesideThePlane",
           "hopper",
           [](Robot& r) { r.tree.bodies[0].inertia.center_of_mass_m.y() = 0.01; },
           {"its centre of mass lies 0.006104 m beside"}},
          {"ProductOfInertia",
           "hopper",
           [](Robot& r) {
             Eigen::Matrix3d& inertia = r.tree.bodies[1].inertia.inertia_kg_m2;
             inertia(0, 1) = inertia(1, 0) = 0.004;
           },
           {"is not symmetric about the sagittal plane", "rolling moment"}},
          // Thigh and calf each beside it, together above it: only motion tells.
          {"MassesBesideEachOther",
           "hopper",
           [](Robot& r) {
             r.tree.bodies[0].inertia.center_of_mass_m.y() = 0.01;
             r.tree.bodies[1].inertia.center_of_mass_m.y() = -0.01 * 7.6 / 3.89;
           },
           {"is not symmetric about the sagittal plane"}},
          {"LeaningKnee",
           "hopper",
           [](Robot& r) { r.tree.bodies[1].joint.axis = Vector3d(0.0, 0.8, 0.6); },
           {"the axis of joint 'knee' leans", "0.8"}},
          {"LeaningRoll",
           "hopper",
           [](Robot& r) { r.tree.bodies[3].joint.axis = Vector3d(0.8, -0.6, 0.0); },
           {"the axis of joint 'ankle_roll' leans", "-0.6"}},
          {"TelescopingLeg",
           "planar_leg",
           [](Robot& r) {
             r.tree.bodies[2].joint.kind = dynamics::JointKind::kPrismatic;
             r.tree.bodies[2].joint.axis = Vector3d::UnitZ();
           },
           {"joint 'knee' slides"}},
          {"RollThatCannotBeZero",
           "hopper",
           [](Robot& r) { r.tree.bodies[3].joint.limits.position_min = 0.1; },
           {"joint 'ankle_roll'", "cannot stay at 0", "0.1"}},
          {"NothingMovesInThePlane",
           "planar_leg",
           [](Robot& r) {
             for (std::size_t i : {1, 2}) {
               r.tree.bodies[i].joint.axis = Vector3d::UnitX();
               r.tree.bodies[i].joint.limits = {};
             }
           },
           {"no joint moves it"}},
          {"RodsThatDoNotMirror",
           "hopper",
           shorten_left_crank,
           {"ankle_pitch and ankle_roll is not symmetric", "% apart"}}};
}

class PlaneRefuses : public testing::TestWithParam<Spoilt> {};

TEST_P(PlaneRefuses, AndSaysWhy) {
  Robot robot = documented_robot(GetParam().robot);
  ASSERT_NO_THROW(sagittal(robot));
  GetParam().spoil(robot);
  try {
    sagittal(robot);
    FAIL() << "taken";
  } catch (const io::SpecError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(robot.name), std::string::npos) << text;
    for (const char* words : GetParam().says) {
      EXPECT_NE(text.find(words), std::string::npos) << words << " is not in: " << text;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, PlaneRefuses, testing::ValuesIn(every_fault()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Stances, AreThoseOfTheFoot) {
  const SagittalRobot hopper = sagittal(documented_robot("hopper"));
  const auto found = stances_of(hopper, {"flat", "heel", "flight", "toe", "flat"});
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found[0].points, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(found[1].points, (std::vector<std::size_t>{0}));
  EXPECT_TRUE(found[2].points.empty());
  EXPECT_EQ(found[3].points, (std::vector<std::size_t>{1}));
  EXPECT_EQ(found[0].force_count(), 3u);
  EXPECT_EQ(found[1].force_count(), 2u);
  EXPECT_EQ(found[2].force_count(), 0u);
  EXPECT_TRUE(found[0].is_flat());
  EXPECT_FALSE(found[1].is_flat());
  EXPECT_EQ(found[2].frame(), PlanFrame::kMass);
  EXPECT_EQ(found[3].frame(), PlanFrame::kSole);
}

TEST(Stances, KnowWhatTheyAdd) {
  const Stance flat{"flat", {0, 1}}, heel{"heel", {0}}, toe{"toe", {1}}, flight{"flight", {}};
  EXPECT_TRUE(flat.adds_to(heel));
  EXPECT_TRUE(heel.adds_to(toe));  // It rolls over.
  EXPECT_TRUE(heel.adds_to(flight));
  EXPECT_FALSE(heel.adds_to(flat));
  EXPECT_FALSE(flight.adds_to(flat));
  EXPECT_FALSE(flat.adds_to(flat));
}

TEST(Stances, OfAPointAreThatPointAndFlight) {
  const SagittalRobot leg = sagittal(documented_robot("planar_leg"));
  const auto found = stances_of(leg, {"flat", "flight", "flat"});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].points, (std::vector<std::size_t>{0}));
  EXPECT_EQ(found[0].force_count(), 2u);
}

TEST(Stances, WithPointsBetweenStandOnTheOutermost) {
  Robot robot = documented_robot("hopper");
  ContactPoint middle = robot.contacts[0];
  middle.point.p_B_m = {0.02, 0.0, -0.08};
  robot.contacts.push_back(middle);
  const auto found = stances_of(sagittal(robot), {"flat", "toe", "flat"});
  EXPECT_EQ(found[0].points, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(found[1].points, (std::vector<std::size_t>{2}));
}

TEST(Stances, RefuseAnOrderThatIsNone) {
  const SagittalRobot hopper = sagittal(documented_robot("hopper"));
  const SagittalRobot leg = sagittal(documented_robot("planar_leg"));
  const auto refusal = [](const SagittalRobot& robot, const std::vector<std::string>& names) {
    try {
      stances_of(robot, names);
    } catch (const io::SpecError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto says = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  EXPECT_PRED2(says, refusal(hopper, {"flat", "tiptoe", "flat"}), "'tiptoe'");
  EXPECT_PRED2(says, refusal(hopper, {"flat", "tiptoe", "flat"}), "flat, heel, toe, flight");
  EXPECT_PRED2(says, refusal(leg, {"flat", "toe", "flat"}), "there are flat, flight");
  EXPECT_PRED2(says, refusal(hopper, {"flat", "flight", "flight", "flat"}), "follows itself");
  EXPECT_PRED2(says, refusal(hopper, {"heel", "flight", "flat"}), "'flat'");
  EXPECT_PRED2(says, refusal(hopper, {"flat", "flight"}), "'flat'");
  EXPECT_PRED2(says, refusal(hopper, {}), "'flat'");
}

}  // namespace
}  // namespace torquewright::hopper
