// SPDX-License-Identifier: Apache-2.0
// Randomisation in the simulators' own forms, run with stand-ins of what they call
// (event_stand_ins.py). Oracle: the document, by hand; of drives that turn several joints virtual
// work, with the mechanism's speeds by finite differences.
#include "hopper/randomised_files/event_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hopper/randomised_files/drives_tolerances.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

bool has_numpy() {
  int status = 0;
  test::output_of(TORQUEWRIGHT_ARRAY_PYTHON " -c 'import numpy' 2>&1", status);
  return status == 0;
}

const std::string kSpecs = TORQUEWRIGHT_SOURCE_DIR "/specs/";

const Robot& hopper() {
  static const Robot robot = read_robot(kSpecs + "robot/hopper.json").robot;
  return robot;
}

const Randomisation& stated() {
  static const Randomisation randomisation = [] {
    Randomisation read = read_randomisation(kSpecs + "randomisation/hopper.json").randomisation;
    read.motor_strength_factor = {{{0.8, 1.1}, {"knee"}, ""},
                                  {{0.9, 1.2}, {"ankle_left", "ankle_right"}, ""}};
    return read;
  }();
  return randomisation;
}

/// What the stand-ins print of a module, a line each.
std::vector<json> lines_of(const std::string& simulator, const std::string& text, double share,
                           const std::string& more = "") {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "module.py";
  std::ofstream(file) << text;
  int status = 0;
  const std::string printed = test::output_of(
      fmt::format("{} {}/tests/hopper/randomised_files/event_stand_ins.py {} {} {} {} 2>&1",
                  TORQUEWRIGHT_ARRAY_PYTHON, TORQUEWRIGHT_SOURCE_DIR, simulator, file.string(),
                  share, more),
      status);
  EXPECT_EQ(status, 0) << printed;
  std::vector<json> lines;
  std::istringstream stream(printed);
  for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
  return lines;
}

std::string events(const std::string& format, std::vector<std::string>* notes = nullptr) {
  std::vector<std::string> own;
  return events_of(*find_event_writer(format), stated(), hopper(), notes ? *notes : own);
}

std::string playground() {
  return "MJCF = r\"\"\"" + mjcf_of(hopper(), {.actuators = true}).text + "\"\"\"\n" +
         events("playground");
}

/// The parameters of every term that calls the function.
std::vector<json> terms(const json& all, const std::string& function) {
  std::vector<json> found;
  for (const auto& [name, term] : all.items()) {
    if (term.at("func") == function) found.push_back(term.at("params"));
  }
  return found;
}

bool holds(const std::vector<std::string>& sentences, const std::string& word) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& each) { return each.find(word) != std::string::npos; });
}

/// Sum over the ankle's drives of what they turn per joint, by differences: 1 Nm of friction each.
double ankle_share(std::size_t joint) {
  const Drivetrain& ankle =
      *std::find_if(hopper().drivetrains.begin(), hopper().drivetrains.end(),
                    [](const Drivetrain& each) { return each.joints.size() > 1; });
  constexpr double kStep_rad = 1e-5;
  const SmallVector home = home_posture_rad(hopper().tree, ankle.joints);
  const auto angles = [&](double offset_rad) {
    SmallVector posture = home;
    posture[static_cast<Eigen::Index>(joint)] += offset_rad;
    return ankle.mechanism->transfer(posture, SmallVector::Zero(posture.size()))
        ->actuator_position_rad;
  };
  return ((angles(kStep_rad) - angles(-kStep_rad)) / (2.0 * kStep_rad)).cwiseAbs().sum();
}

TEST(EventFile, IsaacLabDrawsWhatTheDocumentSays) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  std::vector<std::string> notes;
  const auto lines = lines_of("isaac-lab", events("isaac-lab", &notes), 1.0);
  ASSERT_EQ(lines.size(), 3u);
  const json& all = lines[0];
  const auto masses = terms(all, "mdp.randomize_rigid_body_mass");
  ASSERT_EQ(masses.size(), 1u);
  EXPECT_EQ(masses[0].at("mass_distribution_params"), json::parse("[0.85, 1.15]"));
  EXPECT_EQ(masses[0].at("recompute_inertia"), false);
  const auto shifts = terms(all, "mdp.randomize_rigid_body_com");
  ASSERT_EQ(shifts.size(), 3u);  // One number for all bodies of a term: so one term for each.
  for (const json& each : shifts) {
    EXPECT_EQ(each.at("asset_cfg").at("body_names").size(), 1u);
    EXPECT_EQ(each.at("com_range").at("y"), json::parse("[-0.03, 0.03]"));
  }
  const auto gains = terms(all, "mdp.randomize_actuator_gains");
  ASSERT_EQ(gains.size(), 1u);
  EXPECT_EQ(gains[0].at("damping_distribution_params"), json::parse("[0.9, 1.1]"));
  const auto material = terms(all, "mdp.randomize_rigid_body_material");
  ASSERT_EQ(material.size(), 1u);
  EXPECT_EQ(material[0].at("restitution_range"), json::parse("[0, 0.2]"));
  EXPECT_TRUE(holds(notes, "bus_voltage_factor"));
  EXPECT_TRUE(holds(notes, "sensor_noise"));
  EXPECT_TRUE(holds(notes, "winding_temperature_K"));
}

// 0.4 Nm on both dry frictions and nothing on the viscous one, whose unit is another; mdp's own
// randomize_joint_parameters adds the range to all three.
TEST(EventFile, IsaacLabsDryFrictionIsOneNumberAndNoViscousOne) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  const json written = lines_of("isaac-lab", events("isaac-lab"), 1.0).at(1);
  const auto near = [&](const char* name, double first, double second) {
    EXPECT_NEAR(written.at(name)[0][0].get<double>(), first, 1e-12) << name;
    EXPECT_NEAR(written.at(name)[0][1].get<double>(), second, 1e-12) << name;
  };
  near("joint_friction_coeff", 0.9, 1.0);
  near("joint_dynamic_friction_coeff", 0.8, 0.9);
  near("joint_viscous_friction_coeff", 0.01, 0.02);
}

// Actuators whose own law gives 10 Nm at each joint: the greatest draw of each joint's drives on
// it, and nothing on a joint that no drive turns.
TEST(EventFile, MotorStrengthScalesWhatTheActuatorsGive) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  for (const char* simulator : {"isaac-lab", "mjlab"}) {
    const auto lines = lines_of(simulator, events(simulator), 1.0);
    const auto drawn = terms(lines[0], "scale_motor_strength");
    ASSERT_EQ(drawn.size(), 2u) << simulator;
    EXPECT_EQ(drawn[0].at("asset_cfg").at("joint_names"), json::parse("[\"knee\"]"));
    EXPECT_EQ(drawn[0].at("strength_range"), json::parse("[0.8, 1.1]"));
    const json& torques = lines.back().at("torques");
    ASSERT_EQ(torques.size(), 4u) << simulator;
    EXPECT_NEAR(torques[0].get<double>(), 11.0, 1e-12) << simulator;  // knee
    EXPECT_NEAR(torques[1].get<double>(), 12.0, 1e-12) << simulator;  // ankle_pitch
    EXPECT_NEAR(torques[2].get<double>(), 10.0, 1e-12) << simulator;  // one without a drive
    EXPECT_NEAR(torques[3].get<double>(), 12.0, 1e-12) << simulator;  // ankle_roll
  }
}

TEST(EventFile, FrictionOfCoupledDrivesIsEachJointsByVirtualWork) {
  const DrawnParts parts = drawn_parts(stated(), hopper());
  std::size_t found = 0;
  for (const PartsRange& each : parts.dry_friction_Nm) {
    for (const std::string& joint : each.names) {
      if (joint == "knee") {
        EXPECT_EQ(each.range.greatest, 0.7);
        ++found;
      }
      for (std::size_t k = 0; k < 2; ++k) {
        if (joint != (k == 0 ? "ankle_pitch" : "ankle_roll")) continue;
        EXPECT_NEAR(each.range.greatest, ankle_share(k), 1e-8);
        EXPECT_EQ(each.range.least, 0.0);
        ++found;
      }
    }
  }
  EXPECT_EQ(found, 3u);
  EXPECT_TRUE(holds(parts.notes, "virtual work"));
}

TEST(EventFile, MjlabDrawsOneNumberForAllMasses) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  const json all = lines_of("mjlab", events("mjlab"), 1.0).at(0);
  const auto masses = terms(all, "dr.body_mass");
  ASSERT_EQ(masses.size(), 1u);
  EXPECT_EQ(masses[0].at("shared_random"), true);
  EXPECT_EQ(terms(all, "dr.body_com_offset").size(), 3u);
  const auto friction = terms(all, "dr.joint_friction");
  ASSERT_FALSE(friction.empty());
  for (const json& each : friction) EXPECT_EQ(each.at("operation"), "add");
  EXPECT_EQ(terms(all, "dr.pd_gains").at(0).at("kp_range"), json::parse("[0.9, 1.1]"));
}

// Every field that is drawn has an axis of its own, and no other; at the greatest of each draw.
TEST(EventFile, PlaygroundsModelVariesByTheDocument) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  const json drawn = lines_of("playground", playground(), 1.0).at(0);
  const json& fields = drawn.at("fields");
  const std::vector<std::string> bodies = drawn.at("bodies");
  const auto index = [](const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::size_t thigh = index(bodies, "thigh");
  ASSERT_LT(thigh, bodies.size());
  EXPECT_NEAR(fields.at("body_mass")[thigh].get<double>(), 2.0 * 1.15, 1e-12);
  EXPECT_NEAR(fields.at("body_inertia")[thigh][2].get<double>(), 3.0 * 1.15, 1e-12);
  EXPECT_NEAR(fields.at("body_ipos")[thigh][1].get<double>(), 0.03, 1e-12);
  EXPECT_EQ(fields.at("body_ipos")[index(bodies, "world")][1], 0.0);
  const std::size_t knee = index(drawn.at("joints"), "knee");
  EXPECT_NEAR(fields.at("dof_frictionloss")[knee].get<double>(), 0.1 + 0.7, 1e-12);
  EXPECT_EQ(fields.at("geom_friction")[0][0], 0.9);
  EXPECT_EQ(fields.at("geom_friction")[0][1], 0.005);
  EXPECT_EQ(fields.at("actuator_ctrlrange")[0][1], 48.0);
  // Gain, bias and force range alike: the same law, of another torque.
  for (const auto& [drive, factor] : {std::pair{"knee", 1.1}, std::pair{"ankle_right", 1.2}}) {
    const std::size_t at = index(drawn.at("actuators"), drive);
    EXPECT_NEAR(fields.at("actuator_gainprm")[at][0].get<double>(), 3.0 * factor, 1e-12);
    EXPECT_NEAR(fields.at("actuator_biasprm")[at][2].get<double>(), -2.0 * factor, 1e-12);
    EXPECT_NEAR(fields.at("actuator_forcerange")[at][0].get<double>(), -7.0 * factor, 1e-12);
  }
  for (const auto& [name, axis] : drawn.at("axes").items()) {
    EXPECT_EQ(axis == 0, name != "opt") << name;
  }
  const json least = lines_of("playground", playground(), 0.0).at(0).at("fields");
  EXPECT_NEAR(least.at("actuator_ctrlrange")[0][1].get<double>(), 0.93 * 48.0, 1e-12);
}

// By hand of bodies of 2 kg and joints of 0.1 Nm, at the greatest of each draw; the base has six
// degrees of freedom in front of the joints'.
TEST(EventFile, NewtonsBuilderVariesByTheDocument) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  std::string names;
  std::vector<std::string> bodies;
  for (const dynamics::Body& body : hopper().tree.bodies) {
    bodies.push_back(body.name);
    names += " " + body.name;
  }
  std::vector<std::string> notes;
  const json drawn = lines_of("newton", events("newton", &notes), 1.0, names).at(0);
  const auto thigh =
      static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), "thigh") - bodies.begin());
  ASSERT_LT(thigh, bodies.size());
  EXPECT_NEAR(drawn.at("body_mass")[thigh].get<double>(), 2.0 * 1.15, 1e-12);
  EXPECT_NEAR(drawn.at("body_inv_mass")[thigh].get<double>(), 0.5 / 1.15, 1e-12);
  EXPECT_NEAR(drawn.at("body_inertia")[thigh][2][2].get<double>(), 3.0 * 1.15, 1e-12);
  EXPECT_NEAR(drawn.at("body_inv_inertia")[thigh][1][1].get<double>(), 0.5 / 1.15, 1e-12);
  EXPECT_NEAR(drawn.at("body_com")[thigh][1].get<double>(), 0.03, 1e-12);
  EXPECT_NEAR(drawn.at("joint_friction")[6].get<double>(), 0.1 + 0.7, 1e-12);
  EXPECT_NEAR(drawn.at("joint_friction")[7].get<double>(), 0.1 + ankle_share(0), 1e-8);
  EXPECT_EQ(drawn.at("joint_friction")[0], 0.1);
  EXPECT_EQ(drawn.at("shape_material_mu")[1], 0.9);
  EXPECT_EQ(drawn.at("shape_material_restitution")[0], 0.2);
  for (const auto& [joint, factor] :
       {std::pair{"knee", 1.1}, std::pair{"ankle_pitch", 1.2}, std::pair{"ankle_roll", 1.2}}) {
    EXPECT_NEAR(drawn.at("strength").at(joint).get<double>(), factor, 1e-12) << joint;
  }
  EXPECT_TRUE(holds(notes, "bus_voltage_factor"));
}

// Two environments, at the greatest of each draw; the entity has 0.5 of friction.
TEST(EventFile, GenesisVariesByEnvironment) {
  if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  std::vector<std::string> notes;
  const json drawn = lines_of("genesis", events("genesis", &notes), 1.0).at(0);
  const std::vector<std::string> bodies = drawn.at("bodies");
  const auto thigh =
      static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), "thigh") - bodies.begin());
  ASSERT_LT(thigh, bodies.size());
  double total_kg = 0.0;
  double shift_kg = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    total_kg += drawn.at("masses").at(bodies[i]).get<double>();
    shift_kg += drawn.at("mass")[0][1][i].get<double>();
  }
  EXPECT_NEAR(shift_kg, 0.15 * total_kg, 1e-9);
  EXPECT_EQ(drawn.at("mass")[2], json::parse("[3, 5]"));
  ASSERT_EQ(drawn.at("com")[1].size(), 3u);
  EXPECT_EQ(drawn.at("com")[1][0], thigh);
  EXPECT_NEAR(drawn.at("com")[0][1][0][2].get<double>(), 0.03, 1e-12);
  EXPECT_NEAR(drawn.at("frictionloss")[0][0][0].get<double>(), 0.1 + 0.7, 1e-12);
  EXPECT_EQ(drawn.at("frictionloss")[1], json::parse("[6, 7, 8]"));
  EXPECT_NEAR(drawn.at("friction")[0][1][0].get<double>(), 0.9 / 0.5, 1e-12);
  EXPECT_TRUE(holds(notes, "body_inertia_factor"));
  // A row for each environment, in the order of DRIVEN, the last of which draws nothing.
  EXPECT_EQ(drawn.at("strength").size(), 2u);
  const std::array strength = {1.1, 1.2, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(drawn.at("strength")[1][i].get<double>(), strength[i], 1e-12);
  }
}

// Oracle: the documents: a stated tolerance, that of several sources, and a catalogue's.
TEST(EventFile, TolerancesAreThoseOfTheDrivesDocuments) {
  Robot robot = hopper();
  actuator::Actuator& knee = robot.drivetrains[0].actuators[0];
  knee.statements.push_back({"/motor/torque_constant_Nm_A", 0.32, {}, {}, 0.05, {}});
  const Randomisation made = tolerances_of_drives(robot);
  ASSERT_EQ(made.motor_strength_factor.size(), 3u);
  EXPECT_EQ(made.motor_strength_factor[0].range.least, 0.95);
  EXPECT_EQ(made.motor_strength_factor[0].names, std::vector<std::string>{"knee"});
  EXPECT_EQ(made.motor_strength_factor[1].range.greatest, 1.1);
  EXPECT_TRUE(holds(made.assumed, "knee: motor strength within 5 %, of /motor/torque_constant"));
  EXPECT_NO_THROW(require_fits(made, robot));
}

TEST(EventFile, IsNotForEveryFormat) {
  EXPECT_EQ(find_event_writer("urdf"), nullptr);
  EXPECT_EQ(find_event_writer("mjcf"), nullptr);
  EXPECT_EQ(randomised_formats().size(), 6u);
}

}  // namespace
}  // namespace torquewright::hopper
