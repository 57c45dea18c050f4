// SPDX-License-Identifier: Apache-2.0
// Oracle: readers of their own for every format (exported_parameters.cpp), which apply each
// simulator's law to the numbers that stand in the file.
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/simulator_file_json.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/actuator/exporters/exported_parameters.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using test::output_of;

// Of the peak torque: some roundings of the conversions (degrees, gear ratio, gains).
constexpr double kPrinted = 1e-11;

void expect_near(double value, double expected, double tolerance) {
  if (std::isinf(expected)) {
    EXPECT_EQ(value, expected);
  } else {
    EXPECT_NEAR(value, expected, tolerance);
  }
}

void expect_round_trip(const Example& example, LawFit fit) {
  const Subject subject = example.subject(fit);
  for (const Exporter* exporter : exporter_library()) {
    SCOPED_TRACE(exporter->name);
    const SimulatorFile file = simulator_file(subject, *exporter, {"origin"});
    const auto law = law_of_file(std::string(exporter->name), file.text);
    const double end_rad_s = 1.5 * example.region.greatest_speed_rad_s();
    const double tolerance_Nm = kPrinted * example.table.peak_torque_Nm;
    for (int i = -600; i <= 600; ++i) {
      const double speed_rad_s = end_rad_s * i / 600;
      const TorqueLimits read = law(speed_rad_s);
      const TorqueLimits meant = exporter->law(file.shape, speed_rad_s);
      expect_near(read.least_Nm, meant.least_Nm, tolerance_Nm);
      expect_near(read.greatest_Nm, meant.greatest_Nm, tolerance_Nm);
    }
  }
}

TEST(RoundTrip, OfALosslessActuator) { expect_round_trip(Example(knee()), LawFit::kConservative); }

TEST(RoundTrip, OfALossyActuatorConservatively) {
  expect_round_trip(Example(lossy_knee()), LawFit::kConservative);
}

TEST(RoundTrip, OfALossyActuatorAtBest) { expect_round_trip(Example(lossy_knee()), LawFit::kBest); }

TEST(RoundTrip, OnTheMotorsSide) {
  expect_round_trip(Example(lossy_knee(), Side::kMotor), LawFit::kConservative);
}

// Each format's own units, by hand: 10.5 rad/s are 601.6056848873644 deg/s.
TEST(Files, HoldTheDocumentedUnits) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  const auto text = [&](const Exporter& exporter) {
    return simulator_file(subject, exporter, {}).text;
  };
  const auto has = [](const std::string& where, const std::string& what) {
    return where.find(what) != std::string::npos;
  };
  EXPECT_TRUE(has(text(exporters::physx), "angular:maxActuatorVelocity = 601.605684887"));
  EXPECT_TRUE(has(text(exporters::physx), "angular:speedEffortGradient = 0.39167036"));
  EXPECT_TRUE(text(exporters::physx).starts_with("#usda 1.0\n"));
  // At the rotor: K = 67.2 V / 210 rad/s = 0.32, R = 0.28, 16 Nm; J without the gear.
  EXPECT_TRUE(has(text(exporters::mujoco_dcmotor), "motorconst=\"0.32 0.32\""));
  EXPECT_TRUE(has(text(exporters::mujoco_dcmotor), "armature=\"0.000922\"") ||
              has(text(exporters::mujoco_dcmotor), "armature=\"0.00092199999"));
  EXPECT_TRUE(has(text(exporters::raisim2), "gear_ratio=\"20\" bus_voltage=\"67.2\""));
  EXPECT_TRUE(has(text(exporters::raisim2), "velocity_constant=\"3.125\""));
  EXPECT_TRUE(has(text(exporters::isaac_lab), "saturation_effort=1536"));
}

TEST(Files, SayWhatAReaderMustKnow) {
  const Example example(lossy_knee());
  const Subject subject = example.subject(LawFit::kBest);
  for (const Exporter* exporter : exporter_library()) {
    SCOPED_TRACE(exporter->name);
    const std::string text = simulator_file(subject, *exporter, {}).text;
    for (const std::string piece :
         {"Fit: best", "Side: joint", "67.2 V", "298.15 K", "coulomb_friction; viscous_friction",
          "Do not also apply friction", "0.3688 kg m^2 = N^2 J", "Assumed: /motor/resistance_ohm",
          "too optimistic", "speed < 0, driving", "at rest, lower", "outside the region"}) {
      EXPECT_NE(text.find(piece), std::string::npos) << piece;
    }
    EXPECT_NE(text.find(exporter->source.substr(0, 30)), std::string::npos);
  }
}

// Names come from documents: whatever they hold, files stay files of their kind.
TEST(Files, SurviveAnyName) {
  Actuator actuator = knee();
  actuator.name = "7 \"knees\" -->\n*/ import os; <x> & \\";
  const Example example(actuator);
  for (const Exporter* exporter : exporter_library()) {
    SCOPED_TRACE(exporter->name);
    const std::string text =
        simulator_file(example.subject(LawFit::kBest), *exporter, {"a --- b\\", "c"}).text;
    EXPECT_NO_THROW(law_of_file(std::string(exporter->name), text)(1.0));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool is_code = line.find("import os") != std::string::npos && !line.starts_with("#") &&
                           !line.starts_with("//") && text.find("<!--") == std::string::npos;
      EXPECT_FALSE(is_code) << line;
    }
  }
}

TEST(Json, HoldsTheFileItsNumbersAndItsErrors) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  const SimulatorFile file = simulator_file(subject, exporters::urdf, {});
  const auto json = simulator_file_json(subject, file);
  EXPECT_EQ(json.at("kind"), "simulator_file");
  EXPECT_EQ(json.at("fit"), "best");
  EXPECT_EQ(json.at("file"), file.text);
  EXPECT_EQ(json.at("side"), "joint");
  EXPECT_NEAR(json.at("parameters").at("greatest_speed_rad_s").get<double>(), 10.5, 1e-12);
  ASSERT_EQ(json.at("errors").size(), 6u);
  EXPECT_EQ(json.at("errors")[0].at("speed"), "positive");
  EXPECT_NEAR(json.at("errors")[0].at("optimistic").at("torque_Nm").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(json.at("share_outside").get<double>(), 2.1875 / 42.0, 1e-6);
  const auto table = simulator_file_json(subject, simulator_file(subject, exporters::drake, {}));
  EXPECT_EQ(table.at("parameters").at("speed_rad_s").size(),
            table.at("parameters").at("torque_max_Nm").size());
}

// Oracle: a C++ compiler. The generated functions, with stand-ins for the classes that they derive
// from and call (signatures as in the headers that the files name; no part of RaiSim or Drake),
// clip as the law says.
TEST(GeneratedCode, CompilesAndIsTheLaw) {
  const Example example(lossy_knee());
  const Subject subject = example.subject(LawFit::kConservative);
  const test::ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "raisim");
  std::filesystem::create_directories(folder.path() / "Eigen");
  std::filesystem::create_directories(folder.path() / "drake/systems/framework");
  folder.write("Eigen/Core",
               "#include <vector>\nnamespace Eigen { using VectorXd = std::vector<double>; }\n");
  folder.write("raisim/World.hpp", R"(#pragma once
#include <vector>
namespace raisim {
struct VecDyn { std::vector<double> v; std::vector<double> e() const { return v; } };
struct ArticulatedSystem {
  std::vector<double> speed, upper, lower;
  VecDyn getActuationUpperLimits() const { return {upper}; }
  VecDyn getActuationLowerLimits() const { return {lower}; }
  VecDyn getGeneralizedVelocity() const { return {speed}; }
  void setActuationLimits(std::vector<double> u, std::vector<double> l) { upper = u; lower = l; }
};
}
)");
  folder.write("drake/systems/framework/leaf_system.h", R"(#pragma once
#include <vector>
namespace drake::systems {
template <typename T> struct Context { std::vector<T> input; };
template <typename T> struct BasicVector { T value; void SetAtIndex(int, T v) { value = v; } };
template <typename T> class LeafSystem {
 public:
  virtual ~LeafSystem() = default;
  struct Port { int i; std::vector<T> Eval(const Context<T>& c) const { return {c.input[i]}; } };
  Port get_input_port(int i) const { return {i}; }
  T run(T torque, T speed) { BasicVector<T> out; calc({{torque, speed}}, out); return out.value; }
 protected:
  void DeclareVectorInputPort(const char*, int) {}
  template <typename S>
  void DeclareVectorOutputPort(const char*, int, void (S::*f)(const Context<T>&, BasicVector<T>*) const) {
    S* self = static_cast<S*>(this);
    call_ = [](void* s, void* m, const Context<T>& c, BasicVector<T>& o) {
      (static_cast<S*>(s)->**static_cast<void (S::**)(const Context<T>&, BasicVector<T>*) const>(m))(c, &o);
    };
    static auto member = f;
    self_ = self; member_ = &member;
  }
 private:
  void calc(const Context<T>& c, BasicVector<T>& o) { call_(self_, member_, c, o); }
  void* self_; void* member_; void (*call_)(void*, void*, const Context<T>&, BasicVector<T>&);
};
}
)");
  folder.write("raisim1.hpp", simulator_file(subject, exporters::raisim1, {}).text);
  std::string drake = simulator_file(subject, exporters::drake, {}).text;
  // Both files name their function after the actuator; here they meet in one program.
  for (std::size_t at = 0; (at = drake.find("lossy_knee_", at)) != std::string::npos; at += 12) {
    drake.replace(at, 11, "other_knee_");
  }
  folder.write("drake.hpp", drake);
  folder.write("main.cpp", R"(#include <cstdio>
#include <cstdlib>
#include "raisim1.hpp"
#include "drake.hpp"
int main() {
  other_knee_limiter limiter;
  for (int i = -50; i <= 50; ++i) {
    const double speed = 0.25 * i;
    raisim::ArticulatedSystem robot{{0.0, speed}, {1.0, 1.0}, {-1.0, -1.0}};
    limit_lossy_knee(robot, 1);
    if (robot.upper[0] != 1.0 || robot.lower[0] != -1.0) return 1;
    std::printf("%.17g %.17g %.17g %.17g %.17g\n", speed, robot.lower[1], robot.upper[1],
                limiter.run(-1e9, speed), limiter.run(1e9, speed));
  }
}
)");
  const std::string program = (folder.path() / "program").string();
  int status = 0;
  const std::string compile = std::string(TORQUEWRIGHT_CXX) + " -std=c++17 -O0 -Wall -I" +
                              folder.path().string() + " " + (folder.path() / "main.cpp").string() +
                              " -o " + program + " 2>&1";
  const std::string complaints = output_of(compile, status);
  ASSERT_EQ(status, 0) << complaints;
  EXPECT_EQ(complaints, "");
  std::istringstream lines(output_of(program, status));
  ASSERT_EQ(status, 0);
  const Shape shape = exporters::raisim1.shape(subject);
  int count = 0;
  double speed, least, greatest, drake_least, drake_greatest;
  while (lines >> speed >> least >> greatest >> drake_least >> drake_greatest) {
    const TorqueLimits meant = exporters::raisim1.law(shape, speed);
    const double tolerance_Nm = kPrinted * example.table.peak_torque_Nm;
    EXPECT_NEAR(least, meant.least_Nm, tolerance_Nm);
    EXPECT_NEAR(greatest, meant.greatest_Nm, tolerance_Nm);
    EXPECT_NEAR(drake_least, meant.least_Nm, tolerance_Nm);
    EXPECT_NEAR(drake_greatest, meant.greatest_Nm, tolerance_Nm);
    ++count;
  }
  EXPECT_EQ(count, 101);
}

class Command : public testing::Test {
 protected:
  std::string run(const std::string& arguments) {
    const std::string errors = (folder_.path() / "stderr").string();
    const std::string text =
        output_of(std::string(TORQUEWRIGHT_BINARY) + " actuator mor " + TORQUEWRIGHT_SOURCE_DIR +
                      "/specs/actuator/d151_knee.json " + arguments + " 2>" + errors,
                  status_);
    std::ifstream stream(errors);
    complaints_ = {std::istreambuf_iterator<char>(stream), {}};
    return text;
  }

  test::ScratchFolder folder_;
  int status_ = 0;
  std::string complaints_;
};

TEST_F(Command, WritesEveryFormatToStdoutOrAFileAndKeepsQuiet) {
  for (const Exporter* exporter : exporter_library()) {
    SCOPED_TRACE(exporter->name);
    const std::string arguments = "--format " + std::string(exporter->name);
    const std::string text = run(arguments);
    EXPECT_EQ(status_, 0);
    EXPECT_EQ(complaints_, "");
    EXPECT_NO_THROW(law_of_file(std::string(exporter->name), text));
    EXPECT_NE(text.find("sha256"), std::string::npos);
    const std::string file = (folder_.path() / "out").string();
    EXPECT_EQ(run(arguments + " -o " + file), "");
    std::ifstream stream(file);
    EXPECT_EQ(text, std::string(std::istreambuf_iterator<char>(stream), {}));
    const auto json = nlohmann::json::parse(run(arguments + " --json --fit best"));
    EXPECT_EQ(json.at("format"), exporter->name);
    EXPECT_EQ(json.at("fit"), "best");
    EXPECT_EQ(json.at("tool").at("name"), "torquewright");
    EXPECT_EQ(complaints_, "");
  }
}

TEST_F(Command, SaysWhichFrictionCannotBeTheJoints) {
  EXPECT_EQ(run("--format raisim1 --friction joint"), "");
  EXPECT_EQ(status_, 2);
  EXPECT_NE(complaints_.find("raisim1 has no field for it"), std::string::npos) << complaints_;
  run("--format mujoco --friction joint --side motor");
  EXPECT_EQ(status_, 2);
  EXPECT_NE(complaints_.find("before any friction"), std::string::npos) << complaints_;
  run("--format csv --friction joint");
  EXPECT_EQ(status_, 2);
  run("--format mujoco --friction elsewhere");
  EXPECT_EQ(status_, 2);
  // If nobody says, the joint's wherever there is one.
  EXPECT_EQ(run("--format mujoco"), run("--format mujoco --friction joint"));
  EXPECT_EQ(run("--format raisim1"), run("--format raisim1 --friction limits"));
  EXPECT_NE(run("--format mujoco"), run("--format mujoco --friction limits"));
}

TEST_F(Command, RefusesWhatItCannotDo) {
  EXPECT_EQ(run("--format bullet"), "");
  EXPECT_EQ(status_, 2);
  run("--format mujoco --fit worst");
  EXPECT_EQ(status_, 2);
  run("--format mujoco --at-speed 1");
  EXPECT_EQ(status_, 2);
  EXPECT_NE(complaints_.find("rows are for csv and json"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::actuator
