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

/// The other motion of the pages: a leg bends and straightens its knee, its foot flat and its hip
/// above its ankle, so that both links lean alike.
constexpr double kThigh_kg = 8.0, kShank_kg = 0.6, kFoot_kg = 0.3, kThigh_kg_m2 = 0.05;
constexpr double kLink_m = 0.25, kAnkle_m = 0.05;
constexpr double kLeast_rad = 0.3, kDeeper_rad = 0.5, kSquat_rad_s = std::numbers::pi;
constexpr double kSquatStep_s = 0.005;
constexpr int kSquatSamples = 401;

struct SquatInstant {
  double bend_rad, bend_rad_s, bend_rad_s2;  ///< Of each link from the plumb line.
  double hip_m() const { return kAnkle_m + 2.0 * kLink_m * std::cos(bend_rad); }
  double hip_acceleration_m_s2() const {
    return -2.0 * kLink_m *
           (std::sin(bend_rad) * bend_rad_s2 + std::cos(bend_rad) * bend_rad_s * bend_rad_s);
  }
};

SquatInstant squat_at(double time_s) {
  const double phase = kSquat_rad_s * time_s, half_rad = 0.5 * kDeeper_rad;
  return {kLeast_rad + half_rad * (1.0 - std::cos(phase)),
          half_rad * kSquat_rad_s * std::sin(phase),
          half_rad * kSquat_rad_s * kSquat_rad_s * std::cos(phase)};
}

/// The bench of the pages: the same drive of 10.5:1 with losses and friction at its output that the
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
  io::CsvReader squat(cli_test::in_repository("specs/trajectory/leg_squat.csv"));
  for (rows = 0; squat.next(); ++rows) {
    const SquatInstant at = squat_at(kSquatStep_s * rows);
    const double row[] = {0.0,         0.0,
                          at.hip_m(),  std::cos(0.5 * at.bend_rad),
                          0.0,         -std::sin(0.5 * at.bend_rad),
                          0.0,         2.0 * at.bend_rad,
                          -at.bend_rad};
    for (std::size_t i = 0; i < std::size(row); ++i) EXPECT_NEAR(squat.number(i + 1), row[i], 1e-9);
  }
  EXPECT_EQ(rows, kSquatSamples);
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

Words file_lines(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
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
    Words lines = step.answers.empty() ? terminal.run(step.typed).lines
                                       : terminal.run(command, step.answers).lines;
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

// Torque at the knee: the thigh's mass is at the hip, which moves along a plumb line, so that the
// shank holds it up and turns it.
double knee_Nm(const SquatInstant& at) {
  const double force_N = kThigh_kg * (9.81 + at.hip_acceleration_m_s2());
  return force_N * kLink_m * std::sin(at.bend_rad) - kThigh_kg_m2 * at.bend_rad_s2;
}

TEST_F(Journey, OwnLegAndItsMotion) {
  take(place_, "specs/trajectory", "leg_squat.csv");
  const auto answers = play("leg.md");
  double most_Nm = 0.0;
  for (int i = 0; i < kSquatSamples; ++i) {
    most_Nm = std::max(most_Nm, std::abs(knee_Nm(squat_at(kSquatStep_s * i))));
  }
  const Words checked = answer(answers, "torquewright robot check");
  EXPECT_NEAR(number_behind(checked, "  knee "), most_Nm, kPrinted * most_Nm);
  const Words replayed = answer(answers, "torquewright robot replay");
  EXPECT_EQ(replayed.front(), "leg_squat.csv: stands");
  // The shank's mass is half-way up; the foot stays.
  const double lowered_m = kLink_m * (std::cos(kLeast_rad) - std::cos(kLeast_rad + kDeeper_rad));
  const double of_all_mm =
      1e3 * lowered_m * (2.0 * kThigh_kg + 0.5 * kShank_kg) / (kThigh_kg + kShank_kg + kFoot_kg);
  EXPECT_NEAR(number_behind(replayed, "the centre of mass goes down by "), of_all_mm,
              kPrinted * of_all_mm + 0.1);
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

// Behind the gears the motor's torque is more by the ratio, less by what they lose; both follow
// from the teeth that are shown.
TEST_F(Journey, GearboxOfTwelveInSixtyEightMillimetresAndItsActuator) {
  const auto answers = play("gearbox.md");
  const Words lines = answer(answers, "torquewright gearbox optimize");
  const auto problem =
      gearbox::read_problem(io::read_document(place_.path("gears.json"), "gearbox_problem"));
  EXPECT_EQ(problem.rotor_inner_diameter_mm, 68);
  const oracles::Enumeration all = oracles::enumerate(problem);
  ASSERT_FALSE(all.best.empty());
  EXPECT_TRUE(all.near_ties.empty());
  const auto teeth = teeth_shown(lines);
  ASSERT_EQ(teeth.size(), 5u) << text_of(lines);
  EXPECT_EQ(teeth, oracles::to_design(problem, all.best.front()).teeth);
  EXPECT_NEAR(ratio_of(teeth), 12.0, 0.24);
  EXPECT_NEAR(number_behind(lines, "objective         mass "),
              static_cast<double>(all.best.front().objective), 1e-8);
  EXPECT_NE(text_of(lines).find("accepted: "), std::string::npos);
  EXPECT_TRUE(place_.text("gears.svg").starts_with("<"));
  EXPECT_NE(place_.text("gears.dxf").find("AC1009"), std::string::npos);
  const double efficiency = number_behind(lines, "efficiency        forward ");
  const double stall_Nm = 0.117 * 45.0 * ratio_of(teeth) * efficiency;
  const Words region = answer(answers, "torquewright actuator mor");
  EXPECT_NEAR(number_behind(region, " to "), stall_Nm, kPrinted * stall_Nm);
}

/// A file of published robots; false where they are not.
bool take_public(const cli_test::Workplace& place, const std::string& folder,
                 const std::string& name) {
  const fs::path robots = cli_test::in_repository("../shared/data/robots");
  if (!fs::exists(robots / folder / name)) return false;
  place.write(name, cli_test::text_of(robots / folder / name));
  return true;
}

TEST_F(Journey, TwoRobotsForIsaacLab) {
  if (!take_public(place_, "unitree_mujoco/unitree_robots/go2", "go2.xml") ||
      !take_public(place_, "anymal_c_simple_description/urdf", "anymal.urdf")) {
    GTEST_SKIP() << "the published robots are not here";
  }
  const auto answers = play("simulators.md");
  const double reduced = 10.5 * kTorqueConstant_Nm_A;
  const double at_40_Nm = kForward * reduced * (kBus_V - reduced * 40.0) / kResistance_ohm;
  const double peak = greatest_Nm(10.5);
  EXPECT_NEAR(number_behind(answer(answers, "grep effort_limit="), "joint_effort_limit="), peak,
              1e-6 * peak);
  EXPECT_NEAR(number_behind(answer(answers, "python3"), "["), at_40_Nm, 1e-6 * peak);
  // Twelve joints, and no other byte.
  const Words before = file_lines(place_.text("anymal.urdf"));
  const Words after = file_lines(place_.text("anymal_drives.urdf"));
  ASSERT_EQ(before.size(), after.size());
  int changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    EXPECT_NE(after[i].find("effort=\"31.185\""), std::string::npos) << after[i];
    ++changed;
  }
  EXPECT_EQ(changed, 12);
}

TEST_F(Journey, ForeignLogInRpmAndMilliseconds) {
  take(place_, "specs/trajectory", "hip.csv");
  take(place_, "specs/log", "bench.csv");
  const auto answers = play("log.md");
  const Words found = answer(answers, "torquewright identify");
  const Fitted share = fitted(found, "driving_coefficient ");
  EXPECT_NEAR(share.value, 1.0 / kForward - 1.0, 5.0 * share.error);
  const Fitted braking_share = fitted(found, "backdriving_coefficient ");
  EXPECT_NEAR(braking_share.value, 1.0 - kBackward, 5.0 * braking_share.error);
  const Fitted coulomb = fitted(found, "coulomb_Nm "), viscous = fitted(found, "viscous_Nm_s_rad ");
  EXPECT_NEAR(coulomb.value, kCoulomb_Nm, 5.0 * coulomb.error);
  EXPECT_LT(coulomb.error, 0.01);
  // In rpm taken for rad/s it would be a tenth of that, and a per cent of an error would show.
  EXPECT_NEAR(viscous.value, kViscous_Nm_s_rad, 5.0 * viscous.error);
  EXPECT_LT(viscous.error, 0.002 * kViscous_Nm_s_rad * 5.0);
  // With both the drive's greatest torque is less by the gears' share of the friction.
  constexpr double kStated_A = 28.0;
  const double greatest = greatest_Nm(kBenchRatio) * kStated_A / kPeak_A;
  double margin_Nm = greatest;
  for (int i = 0; i < kSamples; ++i) {
    const Instant at = hip_at(kStep_s * i);
    const double torque_Nm = asked_Nm(at, kBenchRatio);
    if (torque_Nm * at.speed_rad_s <= 0.0) continue;
    margin_Nm =
        std::min(margin_Nm, greatest - kForward * drag_Nm(at.speed_rad_s) - std::abs(torque_Nm));
  }
  const Words second = answer(answers, "torquewright actuator check", 1);
  EXPECT_NEAR(number_behind(second, "margin   peak torque "), margin_Nm,
              5.0 * (coulomb.error + share.error * greatest) + 1e-3);
  EXPECT_NE(place_.text("bench.html").find("Measured and predicted, run by run"),
            std::string::npos);
}

// Ten minutes: what is to be read at 150 words a minute, what is to be typed at 100 letters.
TEST(Journeys, TakeTenMinutes) {
  constexpr double kWords = 150.0, kLetters = 100.0, kMinutes = 10.0;
  for (const char* page : {"leg.md", "gearbox.md", "simulators.md", "log.md"}) {
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
    const auto steps = steps_of(text);
    const auto is_ours = [](const Step& step) {
      return step.typed.front().starts_with("torquewright");
    };
    EXPECT_EQ(std::count_if(steps.begin(), steps.end(), is_ours), 5) << page;
    const auto is_document = [](const Step& step) { return step.typed.size() > 1; };
    EXPECT_LE(std::count_if(steps.begin(), steps.end(), is_document), 1) << page;
    const std::string read_me = cli_test::text_of(cli_test::in_repository("README.md"));
    EXPECT_NE(read_me.find(std::string("docs/journeys/") + page), std::string::npos) << page;
  }
}

}  // namespace
}  // namespace torquewright::journeys
