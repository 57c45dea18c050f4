// SPDX-License-Identifier: Apache-2.0
// The exported module as training scripts use it (training_module.py), for every example actuator.
// Oracles: the region's table by its own search (table_law.hpp); over voltage and temperature the
// region itself where one line of the winding is it, else the grid in C++; of the launches on a GPU
// and of what a compiler traces the plain way, in triton_stub's language; numbers by hand; what
// Isaac Lab does with a configuration by the rules of its public sources (python_classes.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "actuator/conditions/winding_line.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/heat/heat_model.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

// Shares of the peak torque, as the exported files say of themselves.
constexpr double kDouble = 1e-11;
constexpr double kSingle = 1e-6;
constexpr double kSingleThere = 1e-6;
constexpr double kSingleUpright = 1e-4;  // beside an upright end, which the last digit moves
constexpr double kThere = 1e-8;          // a grid stands in the file with ten digits

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Over the region and beyond, and closer and closer to both ends, where a bound may be upright.
std::vector<double> speeds_to(double end_rad_s, std::mt19937& dice) {
  std::uniform_real_distribution<double> anywhere(-1.2 * end_rad_s, 1.2 * end_rad_s);
  std::uniform_real_distribution<double> decade(-8.0, -1.0);
  std::vector<double> speeds{0.0, -0.0, rounded(end_rad_s), rounded(-end_rad_s)};
  for (int i = 0; i < 1500; ++i) {
    speeds.push_back(rounded(anywhere(dice)));
    const double nearly = end_rad_s * (1.0 - std::pow(10.0, decade(dice)));
    speeds.push_back(rounded(i % 2 == 0 ? nearly : -nearly));
  }
  return speeds;
}

TorqueLimits limits_there(const Subject& subject, const RegionGrid& grid, bool is_line,
                          double speed_rad_s, double voltage_V, double temperature_K) {
  if (!is_line) {
    const Interval found = limits(grid, speed_rad_s, voltage_V, temperature_K);
    return {found.least_Nm, found.greatest_Nm};
  }
  OperatingConditions there = subject.conditions;
  there.bus_voltage_V = voltage_V;
  there.winding_temperature_K = temperature_K;
  const Region region(subject.actuator, there, subject.region.side());
  // Past its end a region is empty; the file holds the bounds of the end.
  const double end_rad_s = (1.0 - 1e-12) * region.greatest_speed_rad_s();
  const JointRange found = region.at(std::clamp(speed_rad_s, -end_rad_s, end_rad_s));
  return {found.least.torque_Nm, found.greatest.torque_Nm};
}

struct Written {
  std::string module;
  json samples;
  bool is_line = false;
};

Written written(const Actuator& actuator) {
  const ExportedDrive drive(actuator, exporters::python,
                            {.fit = LawFit::kBest, .friction = FrictionPlace::kJoint});
  const Subject& subject = drive.subject();
  const SimulatorFile file = simulator_file(subject, exporters::python, {"origin"});
  const auto grid = region_grid(subject.actuator, subject.conditions, subject.region.side());
  Written all{file.text, json::object(), winding_line(*grid).has_value()};
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> volts(grid->voltages_V.front(), grid->voltages_V.back());
  std::uniform_real_distribution<double> kelvins(grid->temperatures_K.front(),
                                                 grid->temperatures_K.back());
  for (const double speed_rad_s : speeds_to(subject.region.greatest_speed_rad_s(), dice)) {
    const TorqueLimits here = table_law(file.shape, speed_rad_s);
    const double voltage_V = rounded(volts(dice));
    const double temperature_K = rounded(kelvins(dice));
    const TorqueLimits there =
        limits_there(subject, *grid, all.is_line, speed_rad_s, voltage_V, temperature_K);
    all.samples["velocity_rad_s"].push_back(speed_rad_s);
    all.samples["least_Nm"].push_back(here.least_Nm);
    all.samples["greatest_Nm"].push_back(here.greatest_Nm);
    all.samples["voltage_V"].push_back(voltage_V);
    all.samples["temperature_K"].push_back(temperature_K);
    all.samples["least_there_Nm"].push_back(there.least_Nm);
    all.samples["greatest_there_Nm"].push_back(there.greatest_Nm);
  }
  return all;
}

std::vector<std::filesystem::path> example_files() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder =
      std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/actuator";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The knee with a winding that warms and a battery of 67.2 V and 0.2 ohm.
Actuator heated_drive() {
  Actuator actuator = knee();
  actuator.name = "heated drive";
  actuator.thermal = Thermal{0.8, 1.5, 60.0, 400.0, 420.0, 298.15};
  Battery battery;
  battery.series_cells = 16.0;
  battery.cell_open_circuit = {{1.0, 4.2}};
  battery.cell_resistance_ohm = 0.0125;
  actuator.battery = battery;
  return actuator;
}

struct Said {
  json facts;
  std::vector<std::string> lines;  ///< The actuators that are one line of their winding.
};

const Said& said() {
  static const Said all = [] {
    Said made;
    const test::ScratchFolder folder;
    for (const std::filesystem::path& file : example_files()) {
      const Written one = written(read_actuator(file).actuator);
      folder.write(file.stem().string() + ".py", one.module);
      folder.write(file.stem().string() + ".json", one.samples.dump());
      if (one.is_line) made.lines.push_back(file.stem().string());
    }
    const Example example(knee());
    folder.write(
        "knee.py",
        simulator_file(example.subject(LawFit::kBest), exporters::python, {"origin"}).text);
    const ExportedDrive heated(heated_drive(), exporters::python,
                               {.fit = LawFit::kBest, .friction = FrictionPlace::kJoint});
    folder.write("heated.py", simulator_file(heated.subject(), exporters::python, {"origin"}).text);
    int status = 0;
    const std::string text =
        test::output_of(TORQUEWRIGHT_ARRAY_PYTHON " " TORQUEWRIGHT_SOURCE_DIR
                                                  "/tests/actuator/exporters/training_module.py " +
                            folder.path().string() + " 2>&1",
                        status);
    EXPECT_EQ(status, 0) << text;
    made.facts = json::parse(text, nullptr, false);
    EXPECT_FALSE(made.facts.is_discarded()) << text;
    return made;
  }();
  return all;
}

class TrainingModule : public testing::Test {
 protected:
  void SetUp() override {
    int status = 0;
    test::output_of(TORQUEWRIGHT_ARRAY_PYTHON " -c 'import numpy' 2>&1", status);
    if (status != 0) GTEST_SKIP() << "python3-numpy is not installed";
    has_torch_ = said().facts.at("numbers").contains("onnx");
  }

  static const json& numbers() { return said().facts.at("numbers"); }

  bool has_torch_ = false;
};

TEST_F(TrainingModule, IsItsLawForEveryExampleInBothPrecisions) {
  ASSERT_EQ(said().facts.at("laws").size(), example_files().size());
  for (const auto& [name, law] : said().facts.at("laws").items()) {
    SCOPED_TRACE(name);
    std::printf("%s: %s\n", name.c_str(), law.dump().c_str());
    const bool is_upright = name == "ak80_9";
    EXPECT_LE(law.at("double"), kDouble);
    EXPECT_LE(law.at("single"), kSingle);
    EXPECT_LE(law.at("double_there"), kThere);
    EXPECT_LE(law.at("single_there"), is_upright ? kSingleUpright : kSingleThere);
    if (!has_torch_) continue;
    EXPECT_LE(law.at("torch"), kSingle);
    EXPECT_LE(law.at("one_launch"), is_upright ? kSingleUpright : kSingleThere);
    EXPECT_LE(law.at("one_kernel"), is_upright ? kSingleUpright : kSingleThere);
  }
}

// Field weakening alone bends ak80_9's line.
TEST_F(TrainingModule, ScalesWhereOneLineOfTheWindingIsTheRegion) {
  EXPECT_EQ(said().lines.size(), example_files().size() - 1);
  EXPECT_EQ(std::count(said().lines.begin(), said().lines.end(), "ak80_9"), 0);
}

// Operations are what costs on a GPU: Isaac Lab's DCMotor has 12 of them.
TEST_F(TrainingModule, IsTracedWholeAndOfFewOperations) {
  if (!has_torch_) GTEST_SKIP() << "python3-torch is not installed";
  for (const auto& [name, law] : said().facts.at("laws").items()) {
    const bool is_table = name == "ak80_9";
    EXPECT_LE(law.at("launches").at("clip"), is_table ? 25 : 12) << name;
    EXPECT_LE(law.at("launches").at("there"), is_table ? 60 : 24) << name;
    EXPECT_GE(law.at("launches").at("clip"), 5) << name;
  }
}

// Oracle: the two-node model solved exactly (HeatModel::step). step() holds the loss over a step of
// 5 ms, in whose middle the winding is warmer by 2.5 ms of 1 K/s: 0.0039/K of that is 1e-5 of it.
// The current by hand: 67.2 i - 0.2 i^2 is the loss, of 1.5 R i^2 of a phase.
TEST_F(TrainingModule, CarriesHeatAndTheSharedSupplyAlong) {
  const json& stepped = said().facts.at("stepped");
  const Actuator drive = heated_drive();
  const double amplitude_A = 100.0 / (20.0 * 0.32) * 2.0 / std::sqrt(3.0);
  const Warmth rise = HeatModel(drive).step(amplitude_A * amplitude_A, 10.0).after({0.0, 0.0});
  for (const std::size_t joint : {0U, 1U}) {
    EXPECT_EQ(stepped.at("reached_Nm")[joint], 100.0);
    EXPECT_NEAR(stepped.at("winding_K")[joint].get<double>() - 298.15, rise[0], 2e-5 * rise[0]);
    EXPECT_NEAR(stepped.at("case_K")[joint].get<double>() - 298.15, rise[1], 1e-4 * rise[1]);
    const double current_A = stepped.at("current_A")[joint];
    const double winding_K = stepped.at("winding_K")[joint];
    const double loss_W =
        winding_loss_W(drive, amplitude_A, at_winding_temperature(drive, winding_K));
    EXPECT_NEAR(67.2 * current_A - 0.2 * current_A * current_A, loss_W, 1e-3 * loss_W);
  }
  EXPECT_GE(rise[0], 5.0);
  // What another drive draws is missing at speed.
  EXPECT_LT(stepped.at("beside_Nm").get<double>(), stepped.at("alone_Nm").get<double>() - 5.0);
  if (!stepped.contains("slopes")) return;
  const double slope = stepped.at("slopes")[1];
  EXPECT_NEAR(stepped.at("slopes")[0].get<double>(), slope, 1e-6 * std::abs(slope));
  EXPECT_GT(slope, 0.0);
}

// What a launch does not know is found the plain way: slopes, other shapes, other precisions.
TEST_F(TrainingModule, LaunchesTakeWhatTheyKnow) {
  if (!has_torch_) GTEST_SKIP() << "python3-torch is not installed";
  const json expected = {{"plain", true},     {"by_robot", true},
                         {"number", false},   {"row", false},
                         {"double", false},   {"turned", false},
                         {"empty", false},    {"other_shape", false},
                         {"slopes", false},   {"written", true},
                         {"no_slopes", true}, {"forward_slopes", false},
                         {"tangents", true},  {"under_double", "torch.float32"}};
  EXPECT_EQ(said().facts.at("left"), expected);
}

TEST_F(TrainingModule, StartsInIsaacLab) {
  const json& start = said().facts.at("start");
  EXPECT_EQ(start.at("text"), "knee:IsaacLabActuator");
  for (const char* claim : {"is_found", "is_pickled", "is_copied", "is_lazy", "mjlab", "region"}) {
    EXPECT_EQ(start.at(claim), true) << claim;
  }
  EXPECT_EQ(start.at("unknown"), "AttributeError: module 'knee' has no attribute 'NoSuchClass'");
}

// By hand: at 9 rad/s the line is at 1536 (1 - 9 / 10.5) = 219.428571 Nm, the cap against the
// motion 320 Nm.
TEST_F(TrainingModule, TakesNumbersOfEveryKind) {
  const double line_Nm = 1536.0 * (1.0 - 9.0 / 10.5);
  const auto expect = [&](const json& found, double tolerance_Nm) {
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].get<double>(), line_Nm, tolerance_Nm);
    EXPECT_NEAR(found[1].get<double>(), -line_Nm, tolerance_Nm);
  };
  expect(numbers().at("whole"), 1e-9);
  EXPECT_EQ(numbers().at("mixed"), "float64");
  EXPECT_EQ(numbers().at("half")[0], "float16");
  expect(numbers().at("half")[1], 0.0625);  // half precision's own step there is 0.125
  EXPECT_EQ(numbers().at("out")[0], true);
  expect(numbers().at("out")[1], 1e-9);
  EXPECT_EQ(numbers().at("narrow_out"),
            "ValueError: knee_D151: out holds float32; the answer is of float64");
  EXPECT_EQ(numbers().at("long"), true);
  for (const json& shape : numbers().at("empty")) EXPECT_EQ(shape, json::parse("[0, 12]"));
  for (const char* name : {"nan", "nan_there"}) {
    const json& found = numbers().at(name);
    EXPECT_EQ(found[0], "nan");
    EXPECT_EQ(found[1], "nan");
    EXPECT_NEAR(std::stod(found[2].get<std::string>()), line_Nm, 1e-9) << name;
  }
  if (!has_torch_) return;
  expect(numbers().at("whole_torch"), 1e-4);
  EXPECT_EQ(numbers().at("half_torch")[0], "torch.bfloat16");
  expect(numbers().at("half_torch")[1], 0.5);  // bfloat16's own step there is 1
  EXPECT_EQ(numbers().at("nan_torch")[1], "nan");
  EXPECT_EQ(numbers().at("mixed_torch"), (json{"torch.float64", "torch.float64"}));
  expect(numbers().at("number_torch"), 1e-9);
  EXPECT_EQ(
      numbers().at("libraries"),
      "ValueError: knee_D151: torque is no tensor, velocity is one; torch.as_tensor makes one");
  EXPECT_EQ(numbers().at("devices"),
            "ValueError: knee_D151: torque is on cpu, velocity on meta; move one of them");
}

TEST_F(TrainingModule, GoesIntoOnnx) {
  if (!has_torch_) GTEST_SKIP() << "python3-torch is not installed";
  const json& kinds = numbers().at("onnx");
  ASSERT_TRUE(kinds.is_array()) << kinds;
  EXPECT_TRUE(std::count(kinds.begin(), kinds.end(), "Min") == 1) << kinds;
}

TEST_F(TrainingModule, RunsOnArraysWhoseDevicesHaveNoHash) {
  ASSERT_EQ(said().facts.at("cupy").size(), 1U);
  EXPECT_NEAR(said().facts.at("cupy")[0].get<double>(), 1536.0 * (1.0 - 9.0 / 10.5), 1e-9);
}

TEST_F(TrainingModule, HoldsTheEdgeBeyondItsConditionsAndSaysSoOnce) {
  const json& flagged = said().facts.at("flagged");
  EXPECT_EQ(flagged.at("is_edge"), true);
  ASSERT_EQ(flagged.at("said").size(), 1U);
  EXPECT_NE(flagged.at("said")[0].get<std::string>().find("lies beyond 33.6 to 80.64"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::actuator
