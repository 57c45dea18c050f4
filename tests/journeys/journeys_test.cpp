// SPDX-License-Identifier: Apache-2.0
// The pages of docs/journeys, typed into a terminal as a user types them. What a page shows must
// stand in the window. Oracles of the numbers: closed forms, and for the gears an enumeration that
// shares no code with the search. What goes in are example files of the same closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>

#include "gearbox/problem_spec.hpp"
#include "io/documents/document.hpp"
#include "io/files/csv.hpp"
#include "tests/cli/workplace.hpp"
#include "tests/journeys/journey.hpp"
#include "tests/journeys/shown_commands.hpp"
#include "tests/journeys/terminal.hpp"
#include "tests/oracles/gearbox_enumeration.hpp"

namespace torquewright::journeys {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr double kShare = 1e-3;    ///< Of numbers on pages, printed to four digits.
constexpr double kPrinted = 6e-4;  ///< Half a unit of the fourth digit, relatively.

/// The drive of the pages: its sheet.
constexpr double kTorqueConstant_Nm_A = 0.11, kResistance_ohm = 0.17, kBus_V = 48.0;
constexpr double kPeak_A = 30.0, kForward = 0.9, kBackward = 0.88, kRotor_kg_m2 = 6.1e-5;

/// The motion of the pages: a leg, a point mass on a rod, swung as a sine about its hip.
constexpr double kSwing_rad = 0.8, kSwing_rad_s = 10.0, kLeg_kg = 4.0, kLeg_m = 0.35;
constexpr double kStep_s = 0.002;
constexpr int kSamples = 1001;

struct Instant {
  double speed_rad_s, acceleration_rad_s2, position_rad;
  double torque_Nm() const {
    return kLeg_kg * kLeg_m * (kLeg_m * acceleration_rad_s2 + 9.81 * std::sin(position_rad));
  }
};

Instant hip_at(double time_s) {
  const double phase = kSwing_rad_s * time_s;
  return {kSwing_rad * kSwing_rad_s * std::cos(phase),
          -kSwing_rad * kSwing_rad_s * kSwing_rad_s * std::sin(phase),
          kSwing_rad * std::sin(phase)};
}

/// What the motion asks of a drive of that ratio where both have one sign, at most, and how many
/// samples ask for more than it has; and the greatest torque at the joint, rotor included.
struct Asked {
  double driving_Nm = 0.0;
  int beyond = 0;
  double at_joint_Nm = 0.0;
};

double greatest_Nm(double ratio) { return ratio * kTorqueConstant_Nm_A * kPeak_A * kForward; }

/// The torque on a load that the motor could hold with what it makes at that instant. Its rotor
/// turns before the gears, which take their share of the load's torque alone.
double asked_Nm(const Instant& at, double ratio) {
  const auto share = [&](double torque_Nm) {
    return torque_Nm * at.speed_rad_s > 0.0 ? kForward : 1.0 / kBackward;
  };
  const double motor_Nm = at.torque_Nm() / share(at.torque_Nm()) +
                          ratio * ratio * kRotor_kg_m2 * at.acceleration_rad_s2;
  return motor_Nm * share(motor_Nm);
}

Asked asked(double ratio) {
  Asked most;
  for (int i = 0; i < kSamples; ++i) {
    const Instant at = hip_at(kStep_s * i);
    const double torque_Nm = asked_Nm(at, ratio);
    most.at_joint_Nm =
        std::max(most.at_joint_Nm,
                 std::abs(at.torque_Nm() + ratio * ratio * kRotor_kg_m2 * at.acceleration_rad_s2));
    if (torque_Nm * at.speed_rad_s <= 0.0) continue;  // braking: 33.8 Nm and more are there
    most.driving_Nm = std::max(most.driving_Nm, std::abs(torque_Nm));
    most.beyond += std::abs(torque_Nm) > greatest_Nm(ratio);
  }
  return most;
}

/// The bench of the pages: the same drive of 10.5:1 with Coulomb friction at its output that the
/// sheet does not state. Driving, the gears take their share of what the friction leaves; driven
/// back, the load carries the friction and the gears take theirs of the load
/// (docs/derivations/motor_region.md).
constexpr double kBenchRatio = 10.5, kCoulomb_Nm = 1.5, kViscous_Nm_s_rad = 0.12;

double drag_Nm(double speed_rad_s) {
  return kCoulomb_Nm + kViscous_Nm_s_rad * std::abs(speed_rad_s);
}

double on_the_load_Nm(double motor_Nm, double speed_rad_s) {
  const double direction = speed_rad_s > 0.0 ? 1.0 : -1.0;
  const double left_Nm = motor_Nm * direction - drag_Nm(speed_rad_s);
  return direction * left_Nm * (left_Nm > 0.0 ? kForward : 1.0 / kBackward);
}

constexpr double kCurrentNoise_A = 0.02, kTorqueNoise_Nm = 0.05;

/// What the bench did in that run.
struct BenchInstant {
  double speed_rad_s, current_A, torque_Nm;
};

BenchInstant bench_at(int run, double time_s) {
  const double greatest_rad_s = 6.0 + 3.0 * run, rate_rad_s = 0.4 + 0.13 * run;
  const double speed_rad_s = greatest_rad_s * std::sin(rate_rad_s * time_s);
  const double acceleration_rad_s2 = greatest_rad_s * rate_rad_s * std::cos(rate_rad_s * time_s);
  const double current_A = 8 * std::sin(1.1 * time_s + run) +
                           7 * std::sin(0.37 * (1 + 0.2 * run) * time_s) +
                           5 * std::sin(2.3 * time_s + 2 * run);
  const double motor_Nm = kBenchRatio * (kTorqueConstant_Nm_A * current_A -
                                         kBenchRatio * kRotor_kg_m2 * acceleration_rad_s2);
  return {speed_rad_s, current_A, on_the_load_Nm(motor_Nm, speed_rad_s)};
}

/// An example file, where a reader of the pages finds it.
void take(const cli_test::Workplace& place, const std::string& folder, const std::string& name) {
  place.write(name, cli_test::text_of(cli_test::in_repository(folder + "/" + name)));
}

// The example files are what the oracles below take them for.
TEST(ExampleFiles, AreTheMotionAndTheBenchOfThePages) {
  constexpr double kDigits = 1e-7, kNoises = 5.0;
  io::CsvReader hip(cli_test::in_repository("specs/trajectory/hip.csv"));
  int rows = 0;
  for (; hip.next(); ++rows) {
    const Instant at = hip_at(kStep_s * rows);
    EXPECT_NEAR(hip.number(1), at.position_rad, kDigits);
    EXPECT_NEAR(hip.number(2), at.speed_rad_s, kDigits);
    EXPECT_NEAR(hip.number(3), at.torque_Nm(), kDigits);
  }
  EXPECT_EQ(rows, kSamples);
  io::CsvReader bench(cli_test::in_repository("specs/log/bench.csv"));
  for (rows = 0; bench.next(); ++rows) {
    const int run = bench.text(0)[1] - '0';
    const BenchInstant at = bench_at(run, 1e-3 * bench.number(1));
    const double rpm = at.speed_rad_s * 30.0 / std::numbers::pi;
    EXPECT_NEAR(bench.number(2), rpm, 1e-4 * std::abs(rpm) + 1e-9);
    EXPECT_NEAR(bench.number(3), at.current_A, kNoises * kCurrentNoise_A);
    EXPECT_NEAR(bench.number(4), at.torque_Nm, kNoises * kTorqueNoise_Nm);
  }
  EXPECT_EQ(rows, 4 * 1500);
}

/// The number behind these words in the first line that holds them; NaN where none does.
double number_behind(const Words& lines, const std::string& words) {
  for (const std::string& line : lines) {
    const std::size_t at = line.find(words);
    if (at != std::string::npos) return std::strtod(line.c_str() + at + words.size(), nullptr);
  }
  return std::nan("");
}

/// "coulomb_Nm 1.49983 ± 0.00059", wherever a line goes on below.
struct Fitted {
  double value = std::nan(""), error = std::nan("");
};

Fitted fitted(const Words& lines, const std::string& name) {
  std::string text;
  for (const std::string& line : lines) {
    text += line.substr(std::min(line.size(), line.find_first_not_of(' '))) + " ";
  }
  const std::size_t at = text.find(name);
  if (at == std::string::npos) return {};
  const std::string sign = "± ";
  const std::size_t plus = text.find(sign, at);
  if (plus == std::string::npos) return {};
  return {std::strtod(text.c_str() + at + name.size(), nullptr),
          std::strtod(text.c_str() + plus + sign.size(), nullptr)};
}

std::string text_of(const Words& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Rows of a table for programs are one word, which nobody breaks.
bool fits(const std::string& line) {
  return letters(line) <= kColumns || line.find(' ') == std::string::npos;
}

class Journey : public testing::Test {
 protected:
  void SetUp() override {
    if (!Terminal::is_installed()) GTEST_SKIP() << "tmux is not installed";
  }

  /// Types the page. The answer to each of its commands, by the command.
  std::vector<std::pair<std::string, Words>> play(const std::string& page) {
    Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
    std::vector<std::pair<std::string, Words>> answers;
    const std::string text = cli_test::text_of(cli_test::in_repository("docs/journeys/" + page));
    for (const Step& step : steps_of(text)) answers.push_back(typed(terminal, step));
    return answers;
  }

  cli_test::Workplace place_;

 private:
  static std::pair<std::string, Words> typed(Terminal& terminal, const Step& step) {
    const std::string& command = step.typed.front();
    Words lines = terminal.run(step.typed).lines;
    if (!lines.empty()) lines.erase(lines.begin());  // what was typed
    if (step.typed.size() > 1) return {command, lines};
    EXPECT_EQ(first_unprinted(step.printed, text_of(lines), kShare), "") << command << "\nshows\n"
                                                                         << text_of(lines);
    if (!command.starts_with("torquewright")) return {command, lines};
    for (const std::string& line : lines) {
      EXPECT_TRUE(fits(line)) << command << " goes beyond the window: " << line;
    }
    return {command, lines};
  }
};

/// The answer to the nth command that begins so.
Words answer(const std::vector<std::pair<std::string, Words>>& answers, const std::string& start,
             int nth = 0) {
  for (const auto& [command, lines] : answers) {
    if (command.starts_with(start) && nth-- == 0) return lines;
  }
  ADD_FAILURE() << "nobody typed " << start;
  return {};
}

TEST_F(Journey, CatalogueDriveAndHipTrajectory) {
  take(place_, "specs/trajectory", "hip.csv");
  const auto answers = play("drive.md");
  const Words first = answer(answers, "torquewright actuator check");
  EXPECT_NEAR(number_behind(first, "margin   peak torque "), greatest_Nm(9) - asked(9).driving_Nm,
              1e-3);
  EXPECT_NEAR(number_behind(first, "torque   peak "), asked(9).at_joint_Nm,
              kPrinted * asked(9).at_joint_Nm);
  EXPECT_NEAR(number_behind(first, "% of samples ("), asked(9).beyond, 1.0);
  const Words need = answer(answers, "torquewright actuator mor");
  EXPECT_NEAR(number_behind(need, "gear ratio: "), 29.75 / greatest_Nm(1), 1e-3);
  EXPECT_NEAR(number_behind(need, "current: "), 29.75 / greatest_Nm(9) * kPeak_A, 1e-2);
  const Words second = answer(answers, "torquewright actuator check", 1);
  EXPECT_NEAR(number_behind(second, "margin   peak torque "),
              greatest_Nm(10.5) - asked(10.5).driving_Nm, 1e-3);
}

/// Teeth of the line "1. sun 46, planet_1 29, ...", and n and module behind them.
std::vector<std::int64_t> teeth_shown(const Words& lines) {
  std::vector<std::int64_t> teeth;
  static const std::regex kGear("(sun|planet_1|planet_2|fixed_ring|output_ring) ([0-9]+)");
  for (const std::string& line : lines) {
    if (!line.starts_with("1. sun ")) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), kGear), none; it != none; ++it) {
      teeth.push_back(std::stoll((*it)[2]));
    }
  }
  return teeth;
}

/// Turns of the sun per turn of the output, by Willis' equation twice
/// (docs/derivations/kinematics).
double ratio_of(const std::vector<std::int64_t>& teeth) {
  const auto z = [&](std::size_t i) { return static_cast<double>(teeth[i]); };
  return (1 + z(3) / z(0)) / (1 - z(3) * z(2) / (z(1) * z(4)));
}

TEST_F(Journey, GearboxOfFifteenInSixtyMillimetres) {
  const auto answers = play("gearbox.md");
  const std::string exact = place_.text("gears.json");
  for (int nth = 0; nth < 2; ++nth) {
    const Words lines = answer(answers, "torquewright gearbox optimize", nth);
    place_.write("asked.json", nth == 1 ? exact
                                        : cli_test::with(exact, "\"ratio_tolerance\": 0,",
                                                         "\"ratio_tolerance\": 0.02,"));
    const auto problem =
        gearbox::read_problem(io::read_document(place_.path("asked.json"), "gearbox_problem"));
    const oracles::Enumeration all = oracles::enumerate(problem);
    ASSERT_FALSE(all.best.empty());
    EXPECT_TRUE(all.near_ties.empty());
    const auto teeth = teeth_shown(lines);
    ASSERT_EQ(teeth.size(), 5u) << text_of(lines);
    EXPECT_EQ(teeth, oracles::to_design(problem, all.best.front()).teeth);
    EXPECT_NEAR(ratio_of(teeth), 15.0, nth == 0 ? 0.3 : 1e-12);
    EXPECT_NEAR(number_behind(lines, "objective         mass "),
                static_cast<double>(all.best.front().objective), 1e-8);
    EXPECT_NE(text_of(lines).find("accepted: "), std::string::npos);
  }
  EXPECT_TRUE(place_.text("gears.svg").starts_with("<"));
}

TEST_F(Journey, RegionForIsaacLabAndMuJoCo) {
  const auto answers = play("simulators.md");
  const Words rows = answer(answers, "torquewright actuator mor");
  EXPECT_NEAR(number_behind(rows, "30,-39.375,"), greatest_Nm(10.5), 1e-9);
  const double reduced = 10.5 * kTorqueConstant_Nm_A;
  const double at_40_Nm = kForward * reduced * (kBus_V - reduced * 40.0) / kResistance_ohm;
  const double braking_Nm = reduced * kPeak_A / kBackward;
  EXPECT_NEAR(number_behind(rows, "40,-39.375,"), at_40_Nm, 1e-6);
  EXPECT_NEAR(braking_Nm, 39.375, 1e-12);
  const double peak = greatest_Nm(10.5);
  EXPECT_NEAR(number_behind(answer(answers, "grep _effort"), "actuator_effort_limit="), peak,
              1e-6 * peak);
  EXPECT_NEAR(number_behind(answer(answers, "grep forcerange"), "forcerange=\"-"), peak,
              1e-6 * peak);
  EXPECT_NEAR(number_behind(answer(answers, "python3"), "["), at_40_Nm, 1e-6 * peak);
}

TEST_F(Journey, ForeignLogInRpmAndMilliseconds) {
  take(place_, "specs/trajectory", "hip.csv");
  take(place_, "specs/log", "bench.csv");
  const auto answers = play("log.md");
  const Words found = answer(answers, "torquewright identify");
  const Fitted coulomb = fitted(found, "coulomb_Nm "), viscous = fitted(found, "viscous_Nm_s_rad ");
  EXPECT_NEAR(coulomb.value, kCoulomb_Nm, 5.0 * coulomb.error);
  EXPECT_LT(coulomb.error, 0.01);
  // In rpm taken for rad/s it would be a tenth of that, and a per cent of an error would show.
  EXPECT_NEAR(viscous.value, kViscous_Nm_s_rad, 5.0 * viscous.error);
  EXPECT_LT(viscous.error, 0.002 * kViscous_Nm_s_rad * 5.0);
  // With both the drive's greatest torque is less by the gears' share of the friction.
  double margin_Nm = greatest_Nm(kBenchRatio);
  for (int i = 0; i < kSamples; ++i) {
    const Instant at = hip_at(kStep_s * i);
    const double torque_Nm = asked_Nm(at, kBenchRatio);
    if (torque_Nm * at.speed_rad_s <= 0.0) continue;
    margin_Nm = std::min(margin_Nm, greatest_Nm(kBenchRatio) - kForward * drag_Nm(at.speed_rad_s) -
                                        std::abs(torque_Nm));
  }
  const Words second = answer(answers, "torquewright actuator check", 1);
  EXPECT_NEAR(number_behind(second, "margin   peak torque "), margin_Nm,
              5.0 * coulomb.error + 1e-3);
  EXPECT_NE(place_.text("bench.html").find("Measured and predicted, run by run"),
            std::string::npos);
}

// Ten minutes: what is to be read at 150 words a minute, what is to be typed at 100 letters.
TEST(Journeys, TakeTenMinutes) {
  constexpr double kWords = 150.0, kLetters = 100.0, kMinutes = 10.0;
  for (const char* page : {"drive.md", "gearbox.md", "simulators.md", "log.md"}) {
    const std::string text =
        cli_test::text_of(cli_test::in_repository(std::string("docs/journeys/") + page));
    std::istringstream stream(text);
    const double words =
        static_cast<double>(std::distance(std::istream_iterator<std::string>(stream), {}));
    double letters = 0.0;
    for (const Step& step : steps_of(text)) {
      for (const std::string& line : step.typed) letters += static_cast<double>(line.size());
    }
    EXPECT_LT(words / kWords + letters / kLetters / 2.0, kMinutes) << page;
    EXPECT_GT(steps_of(text).size(), 3u) << page;
    const std::string read_me = cli_test::text_of(cli_test::in_repository("README.md"));
    EXPECT_NE(read_me.find(std::string("docs/journeys/") + page), std::string::npos) << page;
  }
}

}  // namespace
}  // namespace torquewright::journeys
