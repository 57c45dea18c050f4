// SPDX-License-Identifier: Apache-2.0
// The exported module and header, run. Oracle: actuator/clip.hpp on the region's table; over
// voltage and temperature the table of a region that is computed there, or the closed form of a
// motor without losses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "actuator/conditions/region_grid.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/mor/clip_table.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using test::output_of;

using nlohmann::json;

constexpr double kAgreement = 1e-6;  // of the peak torque, as issue and documentation promise

constexpr std::size_t kRandomSamples = 2000;

struct Samples {
  std::vector<double> torque_Nm;
  std::vector<double> velocity_rad_s;
  std::vector<double> voltage_V;  ///< Empty, as the next: those of the table.
  std::vector<double> temperature_K;
};

/// Both quadrants of either sign of speed, rest (twice, as 0 and -0), and beyond the ends.
Samples random_samples(const Example& example) {
  const double end_rad_s = 1.3 * example.region.greatest_speed_rad_s();
  const double most_Nm = 1.5 * example.table.peak_torque_Nm;
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> speed(-end_rad_s, end_rad_s);
  std::uniform_real_distribution<double> torque(-most_Nm, most_Nm);
  Samples samples;
  for (std::size_t i = 0; i < kRandomSamples; ++i) {
    samples.torque_Nm.push_back(i < 4 ? (i % 2 == 0 ? most_Nm : -most_Nm) : torque(dice));
    samples.velocity_rad_s.push_back(i < 2 ? 0.0 : i < 4 ? -0.0 : speed(dice));
  }
  // The table's own speeds, which are corners and both sides of jumps.
  for (const double corner_rad_s : clip_points(example.table).speeds_rad_s) {
    for (const double torque_Nm : {most_Nm, -most_Nm}) {
      samples.torque_Nm.push_back(torque_Nm);
      samples.velocity_rad_s.push_back(corner_rad_s);
    }
  }
  return samples;
}

/// Of the knee's grid, whichever losses it has: half to 1.2 times 67.2 V.
void add_conditions(Samples& samples) {
  std::mt19937 dice(6);
  for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
    samples.voltage_V.push_back(std::uniform_real_distribution<double>(33.6, 80.64)(dice));
    samples.temperature_K.push_back(std::uniform_real_distribution<double>(273.15, 393.15)(dice));
  }
}

std::string text_of(const Example& example, const Exporter& exporter, LawFit fit) {
  return simulator_file(example.subject(fit), exporter, {"origin"}).text;
}

bool has_module(const std::string& name) {
  int status = 0;
  output_of(TORQUEWRIGHT_ARRAY_PYTHON
                " -c 'import importlib.util as u, sys; sys.exit(not u.find_spec(\"" +
                name + "\"))' 2>&1",
            status);
  return status == 0;
}

struct Case {
  std::string module;
  Samples samples;
};

/// What region_module.py says of each.
json run_modules(const std::string& library, const std::vector<Case>& cases) {
  const test::ScratchFolder folder;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Samples& samples = cases[i].samples;
    json given{{"torque_Nm", samples.torque_Nm}, {"velocity_rad_s", samples.velocity_rad_s}};
    if (!samples.voltage_V.empty()) {
      given["voltage_V"] = samples.voltage_V;
      given["temperature_K"] = samples.temperature_K;
    }
    folder.write(std::to_string(i) + ".py", cases[i].module);
    folder.write(std::to_string(i) + ".json", given.dump());
  }
  int status = 0;
  const std::string text = output_of(TORQUEWRIGHT_ARRAY_PYTHON " " TORQUEWRIGHT_SOURCE_DIR
                                                               "/tests/actuator/exporters/"
                                                               "region_module.py " +
                                         library + " " + folder.path().string() + " 2>&1",
                                     status);
  EXPECT_EQ(status, 0) << text;
  const json answer = json::parse(text, nullptr, false);
  EXPECT_FALSE(answer.is_discarded()) << text;
  return answer;
}

void expect_clipped(const std::vector<double>& clipped_Nm, const std::vector<double>& expected_Nm,
                    double tolerance_Nm, const Samples& samples) {
  for (std::size_t i = 0; i < expected_Nm.size(); ++i) {
    EXPECT_NEAR(clipped_Nm[i], expected_Nm[i], tolerance_Nm)
        << samples.torque_Nm[i] << " Nm at " << samples.velocity_rad_s[i] << " rad/s";
  }
}

std::vector<double> clipped_by(const TableView& table, const Samples& samples) {
  std::vector<double> clipped_Nm(samples.torque_Nm.size());
  clip(table, samples.velocity_rad_s.data(), samples.torque_Nm.data(), clipped_Nm.data(),
       clipped_Nm.size());
  return clipped_Nm;
}

/// The knee with a battery that sags, and all of lossy_knee's losses.
Actuator sagging_knee() {
  Actuator actuator = lossy_knee();
  Battery battery;
  battery.series_cells = 16;
  battery.parallel_cells = 4;
  battery.cell_open_circuit = {{1.0, 4.2}};
  battery.cell_resistance_ohm = 0.015;
  actuator.battery = battery;
  return actuator;
}

/// What the tests ask of one library: a process of Python serves them all.
std::vector<Case> every_case() {
  std::vector<Case> cases;
  for (const Actuator& actuator : {knee(), lossy_knee(), sagging_knee()}) {
    const Example example(actuator);
    cases.push_back({text_of(example, exporters::python, LawFit::kBest), random_samples(example)});
  }
  const Example lossy(lossy_knee());
  cases.push_back(
      {text_of(lossy, exporters::python, LawFit::kConservative), random_samples(lossy)});
  for (const std::size_t same : {0, 2}) {
    cases.push_back(cases[same]);
    add_conditions(cases.back().samples);
  }
  return cases;
}
enum CaseNumber : std::size_t { kKnee, kLossy, kSagging, kConservative, kKneeUnder, kSaggingUnder };

const std::vector<Case>& cases() {
  static const std::vector<Case> all = every_case();
  return all;
}

class InEachLibrary : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string library = GetParam();
    const std::string needed = library.starts_with("torch") ? "torch" : "numpy";
    if (!has_module(needed)) GTEST_SKIP() << "python3-" << needed << " is not installed";
  }

  static const json& answer(std::size_t number) {
    static std::map<std::string, json> known;
    json& all = known[GetParam()];
    if (all.is_null()) all = run_modules(GetParam(), cases());
    return all.at(number);
  }

  static bool is_single() { return std::string(GetParam()) == "torch32"; }

  /// Of a clip, and of the simulators' classes where they were run. Single precision rounds speeds
  /// to 2^-24 of themselves and places to 2^-21 of a stretch, over which a bound changes by twice
  /// the peak at most; the table's own speeds are left to double precision, since the last digits
  /// tell on which side of a jump they lie.
  static void expect(std::size_t number, std::vector<double> expected_Nm, double peak_Nm) {
    const double tolerance_Nm = (is_single() ? 5e-6 : kAgreement) * peak_Nm;
    const std::size_t count = is_single() ? kRandomSamples : expected_Nm.size();
    expected_Nm.resize(count);
    for (const char* by : {"clipped_Nm", "isaac_lab_Nm", "mjlab_Nm"}) {
      SCOPED_TRACE(by);
      if (!answer(number).contains(by)) continue;
      std::vector<double> found_Nm = answer(number).at(by).get<std::vector<double>>();
      ASSERT_EQ(found_Nm.size(), cases()[number].samples.torque_Nm.size());
      found_Nm.resize(count);
      expect_clipped(found_Nm, expected_Nm, tolerance_Nm, cases()[number].samples);
    }
  }
};

TEST_P(InEachLibrary, ClipsAsClipHppDoes) {
  for (const auto& [number, actuator] : {std::pair{kKnee, knee()}, std::pair{kLossy, lossy_knee()},
                                         std::pair{kSagging, sagging_knee()}}) {
    SCOPED_TRACE(actuator.name);
    const Example example(actuator);
    const ClipTable table(example.table);
    expect(number, clipped_by(table.view(), cases()[number].samples), example.table.peak_torque_Nm);
  }
}

// Oracle: the table as the conservative fit draws it in, by clip.hpp.
TEST_P(InEachLibrary, ClipsInsideWhenConservative) {
  const Example example(lossy_knee());
  const Shape shape = exporters::python.shape(example.subject(LawFit::kConservative));
  const std::size_t rows = shape.size() / 3;
  const auto block = [&](std::size_t i) {
    const auto begin = shape.begin() + static_cast<std::ptrdiff_t>(i * rows);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(rows));
  };
  const ClipTable table(ClipPoints{block(0), block(1), block(2)});
  expect(kConservative, clipped_by(table.view(), cases()[kConservative].samples),
         example.table.peak_torque_Nm);
}

/// Oracle: closed form. R(T) = R (1 + 0.0039 (T - 298.15)), cap 20 Kt I whatever V and T, bounds
/// +-cap and (K/R)(+-V - K w) with K = 20 Kt, past the overspeed the cap against the motion.
double lossless_knee_Nm(const Samples& samples, std::size_t i) {
  const double resistance_ohm = 0.28 * (1.0 + 0.0039 * (samples.temperature_K[i] - 298.15));
  const double volts = samples.voltage_V[i];
  const double joint_Nm_A = 20.0 * 0.32;
  const Parallelogram there{joint_Nm_A * volts / resistance_ohm, volts / joint_Nm_A,
                            joint_Nm_A * 50.0};
  return clip(there, samples.velocity_rad_s[i], samples.torque_Nm[i]);
}

TEST_P(InEachLibrary, FollowsVoltageAndTemperatureOfALosslessMotor) {
  const Samples& samples = cases()[kKneeUnder].samples;
  std::vector<double> expected_Nm;
  for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
    expected_Nm.push_back(lossless_knee_Nm(samples, i));
  }
  expect(kKneeUnder, expected_Nm, 320.0);
}

// Oracle: the grid in C++, which tests/actuator/region_grid_test.cpp holds against regions.
TEST_P(InEachLibrary, FollowsVoltageAndTemperatureOfAnyOther) {
  const Actuator actuator = sagging_knee();
  const auto grid = region_grid(actuator, {}, Side::kJoint);
  ASSERT_TRUE(grid);
  const Samples& samples = cases()[kSaggingUnder].samples;
  std::vector<double> expected_Nm;
  for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
    expected_Nm.push_back(torquewright_clamp(
        samples.torque_Nm[i],
        limits(*grid, samples.velocity_rad_s[i], samples.voltage_V[i], samples.temperature_K[i])));
  }
  expect(kSaggingUnder, expected_Nm, 310.0);
}

class InPyTorch : public InEachLibrary {};

TEST_P(InPyTorch, HasFiniteSlopes) {
  for (const std::size_t number : {kKnee, kSagging, kKneeUnder, kSaggingUnder}) {
    double greatest = 0.0;
    for (const json& slopes : answer(number).at("slopes")) {
      for (const json& slope : slopes) {
        ASSERT_TRUE(slope.is_number()) << slope;
        ASSERT_TRUE(std::isfinite(slope.get<double>()));
        greatest = std::max(greatest, std::abs(slope.get<double>()));
      }
    }
    EXPECT_GE(greatest, 1.0);  // of torque by torque inside the region
  }
}

INSTANTIATE_TEST_SUITE_P(Python, InEachLibrary,
                         testing::Values("numpy", "standard", "torch", "torch32"));
INSTANTIATE_TEST_SUITE_P(Python, InPyTorch, testing::Values("torch", "torch32"));

class Module : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_module("numpy")) GTEST_SKIP() << "python3-numpy is not installed";
  }
};

TEST_F(Module, ImportsNothingAndHandsOnWhatIsNotANumber) {
  const Example example(lossy_knee());
  const std::string text = text_of(example, exporters::python, LawFit::kConservative);
  const json answer = run_modules("numpy", {{text, random_samples(example)}}).at(0);
  EXPECT_EQ(answer.at("imported"), json::array());
  int status = 0;
  const test::ScratchFolder folder;
  folder.write("region.py", text);
  const std::string said = output_of(
      "cd " + folder.path().string() +
          " && " TORQUEWRIGHT_ARRAY_PYTHON
          " -c 'import numpy as n, region; a = n.asarray([n.nan, 1.0]); b = n.asarray([1.0, "
          "n.nan]); print(region.clip(a, b), region.clip(b, a, 60.0))' 2>&1",
      status);
  EXPECT_EQ(said, "[nan nan] [nan nan]\n");
}

// By hand: at infinite speed the cap is left, against the motion.
TEST_F(Module, TakesAnySpeedAndSingleNumbers) {
  int status = 0;
  const test::ScratchFolder folder;
  folder.write("region.py", text_of(Example(knee()), exporters::python, LawFit::kBest));
  const std::string said = output_of(
      "cd " + folder.path().string() +
          " && " TORQUEWRIGHT_ARRAY_PYTHON
          " -c 'import numpy as n, region; w = n.float64(n.inf); t = n.float64(5.0);"
          " print(round(float(region.clip(t, w)), 6), round(float(region.clip(t, -w, 60.0)), 6),"
          " round(float(region.clip(t, n.float64(0.0), None, 350.0)), 6))' 2>&1",
      status);
  EXPECT_EQ(said, "-320.0 320.0 5.0\n");
  const std::string refused = output_of("cd " + folder.path().string() +
                                            " && " TORQUEWRIGHT_ARRAY_PYTHON
                                            " -c 'import region; region.clip(1.0, 2.0)' 2>&1",
                                        status);
  EXPECT_NE(refused.find("velocity must be an array"), std::string::npos) << refused;
}

// By hand: the knee's cap is 320 Nm, N^2 J 0.3688 kg m^2.
TEST_F(Module, FillsTheSimulatorsConfigurations) {
  const Example example(knee());
  const json answer =
      run_modules("numpy", {{text_of(example, exporters::python, LawFit::kConservative),
                             random_samples(example)}})
          .at(0);
  const json& isaac = answer.at("isaac_lab_fields");
  EXPECT_EQ(isaac.at("joint_names_expr"), json::array({"knee"}));
  EXPECT_EQ(isaac.at("stiffness"), 20.0);
  EXPECT_EQ(isaac.at("viscous_friction"), 0.0);
  EXPECT_NEAR(isaac.at("armature").get<double>(), 0.3688, 1e-12);
  EXPECT_NEAR(isaac.at("actuator_effort_limit").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(isaac.at("joint_effort_limit").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(answer.at("older_fields").at("effort_limit").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(answer.at("older_fields").at("effort_limit_sim").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(answer.at("mjlab_fields").at("effort_limit").get<double>(), 320.0, 1e-6);
  EXPECT_NEAR(answer.at("mjlab_fields").at("armature").get<double>(), 0.3688, 1e-12);
}

constexpr const char* kCProgram = R"(#include "first.h"
#include "second.h"

#include <stdio.h>

int main(void) {
  double torque, velocity, voltage, temperature, clipped;
  while (scanf("%lf %lf %lf %lf", &torque, &velocity, &voltage, &temperature) == 4) {
    torquewright_region_clip_all(&lossy_knee, &torque, &velocity, &clipped, 1);
    printf("%.17g %.17g %.17g %.17g\n", lossy_knee_clip(torque, velocity), clipped,
           knee_D151_clip(torque, velocity),
           knee_D151_clip_under(torque, velocity, voltage, temperature));
  }
  return 0;
}
)";

/// Compiled by that command, run on the samples.
std::vector<std::array<double, 4>> run_header(const std::string& compiler, const Samples& samples) {
  const test::ScratchFolder folder;
  folder.write("first.h", text_of(Example(lossy_knee()), exporters::c, LawFit::kBest));
  folder.write("second.h", text_of(Example(knee()), exporters::c, LawFit::kBest));
  folder.write("main.c", kCProgram);
  std::ostringstream lines;
  lines.precision(17);
  for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
    lines << samples.torque_Nm[i] << ' ' << samples.velocity_rad_s[i] << ' ' << samples.voltage_V[i]
          << ' ' << samples.temperature_K[i] << '\n';
  }
  folder.write("samples", lines.str());
  int status = 0;
  const std::string here = "cd " + folder.path().string() + " && ";
  const std::string complaints = output_of(here + compiler + " -o program 2>&1", status);
  EXPECT_EQ(status, 0) << complaints;
  EXPECT_EQ(complaints, "");
  std::istringstream printed(output_of(here + "./program < samples", status));
  EXPECT_EQ(status, 0);
  std::vector<std::array<double, 4>> all;
  for (std::array<double, 4> row{}; printed >> row[0] >> row[1] >> row[2] >> row[3];) {
    all.push_back(row);
  }
  return all;
}

void expect_header(const std::string& compiler) {
  const Example lossy(lossy_knee());
  const Example lossless(knee());
  const ClipTable lossy_table(lossy.table);
  const ClipTable lossless_table(lossless.table);
  Samples samples = random_samples(lossy);
  add_conditions(samples);
  const auto rows = run_header(compiler, samples);
  ASSERT_EQ(rows.size(), samples.torque_Nm.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double speed_rad_s = samples.velocity_rad_s[i];
    const double torque_Nm = samples.torque_Nm[i];
    // The same algorithm on the same numbers: the same bits.
    EXPECT_EQ(rows[i][0], clip(lossy_table.view(), speed_rad_s, torque_Nm)) << speed_rad_s;
    EXPECT_EQ(rows[i][1], rows[i][0]);
    EXPECT_EQ(rows[i][2], clip(lossless_table.view(), speed_rad_s, torque_Nm)) << speed_rad_s;
    EXPECT_NEAR(rows[i][3], lossless_knee_Nm(samples, i), kAgreement * 320.0)
        << speed_rad_s << " rad/s " << samples.voltage_V[i] << " V " << samples.temperature_K[i];
  }
}

TEST(Header, ClipsAsClipHppDoesInC99) {
  expect_header(TORQUEWRIGHT_CC " -std=c99 -O1 -Wall -Wextra -Werror -pedantic main.c");
}

TEST(Header, ClipsAsClipHppDoesInCxx) {
  expect_header(TORQUEWRIGHT_CXX " -std=c++11 -O1 -Wall -Wextra -Werror -pedantic -x c++ main.c");
}

}  // namespace
}  // namespace torquewright::actuator
