// SPDX-License-Identifier: Apache-2.0
// A drive's friction in the fields of a simulator's joint. Oracles: numbers by hand; what MuJoCo
// makes of them is in mujoco_friction_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/exporters/simulator_file_json.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kWarm_K = kDefaultTemperature_K;
constexpr double kEnd_rad_s = 25.0;

Actuator with_effects(std::vector<Effect> effects) {
  Actuator actuator = dry_drive();
  actuator.effects = std::move(effects);
  return actuator;
}

struct Written {
  explicit Written(const Actuator& actuator, const Exporter& exporter,
                   FrictionPlace place = FrictionPlace::kJoint)
      : drive(actuator, exporter, {.friction = place}),
        file(simulator_file(drive.subject(), exporter, {})) {}
  ExportedDrive drive;
  SimulatorFile file;
};

// Whole numbers of the document, to the last bit: they are printed.
TEST(JointFriction, IsTheDocumentsWhereItsLawsAreDryAndViscous) {
  EXPECT_EQ(joint_friction(dry_drive(), kWarm_K, kEnd_rad_s), (JointFriction{0.4, 0.4, 0.02}));
  EXPECT_EQ(joint_friction(knee(), kWarm_K, kEnd_rad_s), JointFriction{});
}

// By hand: (0.6 + 0.4) / 2 and (0.03 + 0.01) / 2; the misfit is half the difference, 0.1 + 0.01 w.
TEST(JointFriction, IsTheMeanOfBothWays) {
  const Actuator actuator = with_effects({effect("asymmetric_friction", {0.6, 0.4, 0.03, 0.01})});
  const JointFriction friction = joint_friction(actuator, kWarm_K, kEnd_rad_s);
  EXPECT_NEAR(friction.coulomb_Nm, 0.5, 1e-15);
  EXPECT_NEAR(friction.viscous_Nm_s_rad, 0.02, 1e-15);
  const auto said = friction_not_held(actuator, kWarm_K, kEnd_rad_s, false, 1.0);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("off by up to 0.35 Nm (at "), std::string::npos) << said[0];
}

// By hand: least squares of a w^2 over [0, E] would start below zero; through zero it is 3 a E / 4.
// Sums over 400 speeds are off from integrals by 1/800 at most.
TEST(JointFriction, IsLeastSquaresOfWhatIsNeither) {
  const Actuator actuator = with_effects({effect("quadratic_drag", {0.002})});
  const JointFriction friction = joint_friction(actuator, kWarm_K, kEnd_rad_s);
  EXPECT_EQ(friction.coulomb_Nm, 0.0);
  EXPECT_NEAR(friction.viscous_Nm_s_rad, 0.75 * 0.002 * 25.0, 0.75 * 0.002 * 25.0 / 800.0);
}

// By hand: 0.5 Nm at rest, 0.2 Nm sliding; a Stribeck speed of 0.05 rad/s leaves 0.3 Nm to one
// speed of 400 at most.
TEST(JointFriction, HasBreakawayApart) {
  const Actuator actuator = with_effects({effect("stribeck_friction", {0.2, 0.5, 0.05})});
  const JointFriction friction = joint_friction(actuator, kWarm_K, kEnd_rad_s);
  EXPECT_NEAR(friction.breakaway_Nm, 0.5, 1e-15);
  EXPECT_NEAR(friction.coulomb_Nm, 0.2, 4.0 * 0.3 / 400.0);
  EXPECT_EQ(friction_not_held(actuator, kWarm_K, kEnd_rad_s, false, 1.0).size(), 2U);
  EXPECT_EQ(friction_not_held(actuator, kWarm_K, kEnd_rad_s, true, 1.0).size(), 1U);
}

// By hand: it slips at its level; between -0.3 and 0.3 Nm lie 0.6 / 60 = 0.01 rad.
TEST(JointFriction, TakesPreslidingFrictionBySlip) {
  const Actuator actuator = with_effects({effect("presliding_friction", {0.3, 60.0})});
  const JointFriction friction = joint_friction(actuator, kWarm_K, kEnd_rad_s);
  EXPECT_NEAR(friction.coulomb_Nm, 0.3, 1e-15);
  EXPECT_NEAR(friction.breakaway_Nm, 0.3, 1e-15);
  EXPECT_EQ(friction.viscous_Nm_s_rad, 0.0);
  EXPECT_TRUE(without_friction(actuator).effects.empty());
  const auto said = friction_not_held(actuator, kWarm_K, kEnd_rad_s, false, 1.0);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("up to 0.6 Nm over some 0.01 rad"), std::string::npos) << said[0];
}

// By hand: 50 K above the document's temperature grease at -0.4 %/K drags 0.8 of what it did.
TEST(JointFriction, FollowsTheWinding) {
  Actuator actuator = dry_drive();
  actuator.effects.push_back(effect("friction_temperature", {-0.004}));
  const double warm_K = actuator.motor.winding_temperature_K + 50.0;
  const JointFriction friction = joint_friction(actuator, warm_K, kEnd_rad_s);
  EXPECT_NEAR(friction.coulomb_Nm, 0.32, 1e-14);
  EXPECT_NEAR(friction.viscous_Nm_s_rad, 0.016, 1e-14);
}

struct Fields {
  const Exporter* exporter;
  std::vector<const char*> pieces;
};

// By hand: 0.02 Nm s/rad are 0.02 pi / 180 = 0.00034906585 Nm s/deg.
TEST(FrictionFields, HoldTheDrivesFrictionInEachSimulatorsUnits) {
  for (const Fields& fields :
       {Fields{&exporters::mujoco, {"damping=\"0.02\" frictionloss=\"0.4\" solreffriction="}},
        Fields{&exporters::mujoco_dcmotor, {"damping=\"0.02\" frictionloss=\"0.4\""}},
        Fields{&exporters::isaac_lab,
               {" friction=0.4,", " dynamic_friction=0.4,", " viscous_friction=0.02,"}},
        Fields{&exporters::mjlab, {" frictionloss=0.4,", " viscous_damping=0.02,"}},
        Fields{&exporters::newton,
               {"builder.joint_friction[dof] = 0.4\n", "builder.joint_damping[dof] = 0.02\n"}},
        Fields{&exporters::unitree_xy, {" Fs=0.4,", " Fd=0.02,"}},
        Fields{&exporters::urdf, {"<dynamics damping=\"0.02\" friction=\"0.4\"/>"}},
        Fields{&exporters::sdf, {"<damping>0.02</damping>", "<friction>0.4</friction>"}},
        Fields{&exporters::raisim2, {"output_damping=\"0.02\" output_friction=\"0.4\""}},
        Fields{&exporters::physx,
               {"staticFrictionEffort = 0.4\n", "dynamicFrictionEffort = 0.4\n",
                "viscousFrictionCoefficient = 0.00034906585"}}}) {
    const std::string text = Written(dry_drive(), *fields.exporter).file.text;
    for (const char* piece : fields.pieces) {
      EXPECT_NE(text.find(piece), std::string::npos) << fields.exporter->name << ": " << piece;
    }
  }
}

// By hand: dry_drive()'s parallelogram, of which friction takes nothing; in the limits it does.
TEST(FrictionFields, LeaveTheLimitsToTheMotor) {
  const Shape joint = Written(dry_drive(), exporters::isaac_lab).file.shape;
  EXPECT_NEAR(joint[0], 329.142857142857, 1e-6);
  EXPECT_NEAR(joint[1], 25.0, 1e-9);
  EXPECT_NEAR(joint[2], 38.4, 1e-9);
  const Shape limits =
      Written(dry_drive(), exporters::isaac_lab, FrictionPlace::kLimits).file.shape;
  EXPECT_LT(limits[2], 38.4 - 0.39);
}

// With its friction in the joint a dry and viscous drive is held at the limits and below them.
TEST(FrictionFields, LeaveNoErrorOfDryAndViscousFriction) {
  const Written written(dry_drive(), exporters::mujoco);
  ASSERT_TRUE(written.file.errors.at_half);
  for (const auto& errors : {written.file.errors.quadrants, *written.file.errors.at_half}) {
    for (const QuadrantError& error : errors) {
      EXPECT_EQ(error.optimistic.torque_Nm, 0.0);
      EXPECT_EQ(error.cautious.torque_Nm, 0.0);
    }
  }
}

// By hand: at rest, where the limit is greatest, half of it is u. Driving 0.9 / 1.03 of (u - 0.4)
// arrives, braking 1 / (0.85 0.96) of (u + 0.4).
TEST(FrictionFields, StateWhatLoadTakesBelowTheLimits) {
  const Written written(loaded_drive(), exporters::mujoco);
  const double half_Nm = 0.5 * written.file.shape[2];
  const double driving_Nm = (half_Nm - 0.4) * (1.0 - 0.9 / 1.03);
  const double braking_Nm = (half_Nm + 0.4) * (1.0 / (0.85 * 0.96) - 1.0);
  const auto& half = *written.file.errors.at_half;
  for (const std::size_t driving : {0U, 3U}) {
    EXPECT_NEAR(half[driving].optimistic.torque_Nm, driving_Nm, 1e-6);
    EXPECT_EQ(half[driving].cautious.torque_Nm, 0.0);
  }
  // Viscous drag adds to what braking carries, up to where the limit begins to fall.
  for (const std::size_t braking : {1U, 2U}) {
    EXPECT_GE(half[braking].cautious.torque_Nm, braking_Nm - 1e-6);
    EXPECT_LE(half[braking].cautious.torque_Nm, braking_Nm + 0.02 * 28.0 * 0.23);
    EXPECT_EQ(half[braking].optimistic.torque_Nm, 0.0);
  }
}

TEST(FrictionFields, SayWhatTheyCannotHold) {
  Actuator actuator = loaded_drive();
  actuator.effects.push_back(effect("stribeck_friction", {0.2, 0.5, 0.3}));
  actuator.effects.push_back(effect("presliding_friction", {0.1, 50.0}));
  const std::string text = Written(actuator, exporters::mjlab).file.text;
  for (const char* piece :
       {"stribeck_friction: the joint has", "stribeck_friction: at rest it holds",
        "presliding_friction: the joint slips at once", "losses in proportion to load, driving",
        "losses in proportion to load, braking", "At a command of half the limit"}) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
  }
  EXPECT_EQ(text.find("Left out: presliding_friction"), std::string::npos);
}

// Isaac Lab 3 refuses our class unless told so (docs/source/concepts/actuators.rst @ 0120677c).
TEST(FrictionFields, NameTheSwitchThatLetsIsaacLabRunTheModule) {
  const std::string text = Written(loaded_drive(), exporters::python).file.text;
  EXPECT_NE(text.find("SimulationCfg(use_newton_actuators=False)"), std::string::npos);
}

TEST(FrictionFields, AreUsedUnlessNoneCanHoldTheDrive) {
  const std::vector<const Exporter*> without{&exporters::raisim1, &exporters::drake,
                                             &exporters::drake_sdf, &exporters::jaxsim,
                                             &exporters::c};
  Actuator locked = dry_drive();
  locked.transmission.backward_efficiency = 0.0;
  for (const Exporter* exporter : exporter_library()) {
    const bool has_none = std::find(without.begin(), without.end(), exporter) != without.end();
    EXPECT_EQ(usual_place(*exporter, dry_drive(), Side::kJoint),
              has_none ? FrictionPlace::kLimits : FrictionPlace::kJoint)
        << exporter->name;
    EXPECT_EQ(usual_place(*exporter, dry_drive(), Side::kMotor), FrictionPlace::kLimits);
    EXPECT_EQ(usual_place(*exporter, locked, Side::kJoint), FrictionPlace::kLimits);
  }
}

TEST(FrictionFields, StandInTheDocumentOfTheFile) {
  const Written joint(dry_drive(), exporters::mujoco);
  const auto json =
      nlohmann::json::parse(simulator_file_json(joint.drive.subject(), joint.file).dump());
  EXPECT_EQ(json.at("joint_friction"),
            nlohmann::json::parse(
                R"({"coulomb_Nm": 0.4, "breakaway_Nm": 0.4, "viscous_Nm_s_rad": 0.02})"));
  EXPECT_EQ(json.at("errors_at_half").size(), 4U);
  EXPECT_EQ(json.at("friction_included"), "gearbox efficiencies 1 driving, 1 back-driven");
  const Written limits(dry_drive(), exporters::mujoco, FrictionPlace::kLimits);
  const auto old =
      nlohmann::json::parse(simulator_file_json(limits.drive.subject(), limits.file).dump());
  EXPECT_FALSE(old.contains("joint_friction"));
  EXPECT_FALSE(old.contains("errors_at_half"));
}

}  // namespace
}  // namespace torquewright::actuator
