// SPDX-License-Identifier: Apache-2.0
// Oracle: the Python interpreter. The configurations for Python are executed with stand-ins for the
// simulators' classes (no part of them), which print what they are given.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

constexpr const char* kStandIns = R"(
import importlib.abc, importlib.machinery, json, runpy, sys, types

given = []

class Recorder:
    def __init__(self, name):
        self.name = name
    def __call__(self, *positional, **named):
        given.append([self.name, named])

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
    if name.startswith("add_"):
        builder = Builder()
        value(builder, 3)
        given.append(["armature", {"armature": builder.joint_armature[8]}])
print(json.dumps(given))
)";

std::string output_of(const std::string& command, int& status) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    text.append(buffer.data(), size);
  }
  status = WEXITSTATUS(::pclose(pipe));
  return text;
}

/// Every keyword of every call, by its name.
json arguments_in(const Exporter& exporter, const Example& example) {
  const test::ScratchFolder folder;
  const std::string runner = folder.write("runner.py", kStandIns).string();
  const std::string file =
      folder
          .write("config.py",
                 simulator_file(example.subject(LawFit::kConservative), exporter, {"origin"}).text)
          .string();
  int status = 0;
  const std::string text =
      output_of(std::string(TORQUEWRIGHT_PYTHON) + " " + runner + " " + file + " 2>&1", status);
  EXPECT_EQ(status, 0) << text;
  json all = json::object();
  const json calls = json::parse(text, nullptr, false);
  if (calls.is_discarded()) return all;
  for (const json& call : calls) all.update(call[1]);
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

// Names come from documents.
TEST(Python, RunsUnderAnyName) {
  Actuator actuator = knee();
  actuator.name = "7 \"knees\"\n'''; raise SystemExit(3) #\\";
  const Example example(actuator);
  for (const Exporter* exporter : {&exporters::isaac_lab, &exporters::mjlab, &exporters::newton,
                                   &exporters::unitree_xy, &exporters::jaxsim}) {
    EXPECT_FALSE(arguments_in(*exporter, example).empty()) << exporter->name;
  }
}

}  // namespace
}  // namespace torquewright::actuator
