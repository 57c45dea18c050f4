// SPDX-License-Identifier: Apache-2.0
// Oracle: the Python interpreter. The configurations for Python are executed with stand-ins for the
// simulators' classes (no part of them), which print what they are given.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using test::output_of;

using nlohmann::json;

constexpr const char* kStandIns = R"(
import importlib.abc, importlib.machinery, json, runpy, sys, types

given = []

class Recorder:
    def __init__(self, name):
        self.name = name
    def __call__(self, *positional, **named):
        given.append([self.name, named])
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self.name + "." + name

class Stub(types.ModuleType):
    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Recorder(name)

class Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    roots = {"isaaclab", "mjlab", "unitree_rl_lab", "newton", "jaxsim"}
    def find_spec(self, name, path, target=None):
        if name.split(".")[0] in self.roots:
            return importlib.machinery.ModuleSpec(name, self, is_package=True)
    def create_module(self, spec):
        return Stub(spec.name)
    def exec_module(self, module):
        module.__path__ = []

sys.meta_path.insert(0, Finder())
names = runpy.run_path(sys.argv[1])

class Builder:
    joint_armature = {}
    joint_q_start = [0, 7, 8, 9]  # behind a floating base
    joint_qd_start = [0, 6, 7, 8]
    def add_actuator(self, controller, **named):
        clamps = [[clamp.name, values] for clamp, values in named.pop("clamping")]
        given.append([controller.name, named])
        given.extend(clamps)

for name, value in list(names.items()):
    if name == "add_actuators":
        builder = Builder()
        value(builder, {joint: 3 for joint in names["ACTUATORS"]})
        given.append(["joints", {"joints": list(names["ACTUATORS"])}])
    elif name.startswith("add_"):
        builder = Builder()
        value(builder, 3)
        given.append(["armature", {"armature": builder.joint_armature.get(8)}])
if "ACTUATORS" in names:
    given.append(["entries", {"entries": len(names["ACTUATORS"])}])
print(json.dumps(given))
)";

/// Every call that the file makes, in order: what is called, and its keywords.
json calls_in(const std::string& configuration) {
  const test::ScratchFolder folder;
  const std::string runner = folder.write("runner.py", kStandIns).string();
  const std::string file = folder.write("config.py", configuration).string();
  int status = 0;
  const std::string text =
      output_of(std::string(TORQUEWRIGHT_PYTHON) + " " + runner + " " + file + " 2>&1", status);
  EXPECT_EQ(status, 0) << text;
  const json calls = json::parse(text, nullptr, false);
  return calls.is_discarded() ? json::array() : calls;
}

/// Every keyword of every call, by its name.
json arguments_in(const Exporter& exporter, const Example& example) {
  json all = json::object();
  for (const json& call : calls_in(
           simulator_file(example.subject(LawFit::kConservative), exporter, {"origin"}).text)) {
    all.update(call[1]);
  }
  return all;
}

struct Field {
  const Exporter* exporter;
  const char* name;
  double value;  ///< Of the knee of seed 001, worked out by hand; see below.
};

// By hand: stall 20 0.32 67.2/0.28 = 1536 Nm, no load 67.2/(20 0.32) = 10.5 rad/s, cap 20 0.32 50 =
// 320 Nm, armature 400 0.000922 = 0.3688 kg m^2, corner 10.5 (1 - 320/1536) = 8.3125 rad/s.
TEST(Python, RunsTheConfigurationsAndFindsTheNumbers) {
  const Example example(knee());
  for (const Field& field :
       {Field{&exporters::isaac_lab, "saturation_effort", 1536.0},
        Field{&exporters::isaac_lab, "actuator_velocity_limit", 10.5},
        Field{&exporters::isaac_lab, "actuator_effort_limit", 320.0},
        Field{&exporters::isaac_lab, "joint_effort_limit", 320.0},
        Field{&exporters::isaac_lab, "armature", 0.3688},
        // K = 67.2 / 10.5 = 6.4 and R = 6.4 67.2 / 1536 = 0.28 ohm.
        Field{&exporters::isaac_lab_2_3, "saturation_effort", 1536.0},
        Field{&exporters::isaac_lab_2_3, "velocity_limit", 10.5},
        Field{&exporters::isaac_lab_2_3, "effort_limit", 320.0},
        Field{&exporters::isaac_lab_2_3, "effort_limit_sim", 320.0},
        Field{&exporters::isaac_lab_2_3, "armature", 0.3688},
        Field{&exporters::isaac_lab_bam, "kt", 6.4},
        Field{&exporters::isaac_lab_bam, "resistance", 0.28},
        Field{&exporters::isaac_lab_bam, "vin", 67.2},
        Field{&exporters::isaac_lab_bam, "actuator_effort_limit", 320.0},
        Field{&exporters::isaac_lab_bam, "armature", 0.3688},
        Field{&exporters::mjlab_dcmotor, "ke", 6.4},
        Field{&exporters::mjlab_dcmotor, "resistance", 0.28},
        Field{&exporters::mjlab_dcmotor, "voltage_limit", 67.2},
        Field{&exporters::mjlab_dcmotor, "effort_limit", 320.0},
        Field{&exporters::mjlab, "saturation_effort", 1536.0},
        Field{&exporters::mjlab, "velocity_limit", 10.5},
        Field{&exporters::mjlab, "effort_limit", 320.0},
        Field{&exporters::mjlab, "armature", 0.3688},
        Field{&exporters::newton, "saturation_effort", 1536.0},
        Field{&exporters::newton, "velocity_limit", 10.5},
        Field{&exporters::newton, "max_motor_effort", 320.0},
        Field{&exporters::newton, "armature", 0.3688}, Field{&exporters::unitree_xy, "X2", 10.5},
        Field{&exporters::unitree_xy, "Y2", 320.0},
        Field{&exporters::unitree_xy, "armature", 0.3688},
        Field{&exporters::jaxsim, "torque_max", 320.0},
        Field{&exporters::jaxsim, "omega_th", 8.3125},
        Field{&exporters::jaxsim, "omega_max", 10.5}}) {
    const json arguments = arguments_in(*field.exporter, example);
    ASSERT_TRUE(arguments.contains(field.name)) << field.exporter->name << " " << field.name;
    // A fitted law (unitree-xy) meets its numbers to the fit's tolerance.
    EXPECT_NEAR(arguments[field.name].get<double>(), field.value, 1e-6 * field.value)
        << field.exporter->name << " " << field.name;
  }
}

/// Two entries of a robot's file, of which the first has joints of names that no one should choose.
std::vector<DriveEntry> robot_entries() {
  return {{"hip", {"left.hip (1)", "right\\hip\"+\n"}, {1536.0, 10.5, 320.0}, 0.25},
          {"knee", {"knee"}, {640.0, 21.0, 160.0}, 0.0}};
}

// By hand: in a regular expression a backslash stands before what is neither letter nor digit.
TEST(Python, RunsTheFilesOfAllDrives) {
  for (const auto& [exporter, joints] : {std::pair{&exporters::isaac_lab, "joint_names_expr"},
                                         std::pair{&exporters::mjlab, "target_names_expr"}}) {
    SCOPED_TRACE(exporter->name);
    const json calls = calls_in(exporter->write_all(robot_entries(), {"note"}));
    ASSERT_EQ(calls.size(), 3U);
    EXPECT_EQ(calls[0][1].at(joints),
              json::array({R"(left\.hip\ \(1\))", "right\\\\hip\\\"\\+\\\n"}));
    EXPECT_EQ(calls[0][1].at("saturation_effort"), 1536.0);
    EXPECT_EQ(calls[0][1].at("armature"), 0.25);
    EXPECT_EQ(calls[1][1].at(joints), json::array({"knee"}));
    EXPECT_EQ(calls[1][1].at("saturation_effort"), 640.0);
    EXPECT_FALSE(calls[1][1].contains("armature"));  // nobody stated one
    EXPECT_EQ(calls[2][1].at("entries"), 2);
  }
}

TEST(Python, RunsNewtonsFileOfAllDrives) {
  const json calls = calls_in(exporters::newton.write_all(robot_entries(), {"note"}));
  json joints;
  std::size_t controllers = 0;
  for (const json& call : calls) {
    if (call[0] == "joints") joints = call[1].at("joints");
    if (call[0] == "ControllerPD") ++controllers;
  }
  EXPECT_EQ(joints, json::array({"left.hip (1)", "right\\hip\"+\n", "knee"}));
  EXPECT_EQ(controllers, 2U + 3U);  // add_hip, add_knee, and add_actuators for three joints
}

// Names come from documents.
TEST(Python, RunsUnderAnyName) {
  Actuator actuator = knee();
  actuator.name = "7 \"knees\"\n'''; raise SystemExit(3) #\\";
  const Example example(actuator);
  for (const Exporter* exporter : {&exporters::isaac_lab, &exporters::isaac_lab_bam,
                                   &exporters::mjlab, &exporters::mjlab_dcmotor, &exporters::newton,
                                   &exporters::unitree_xy, &exporters::jaxsim}) {
    EXPECT_FALSE(arguments_in(*exporter, example).empty()) << exporter->name;
  }
}

}  // namespace
}  // namespace torquewright::actuator
