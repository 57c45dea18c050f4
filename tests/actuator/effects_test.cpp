// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "actuator/effects/effect_spec.hpp"
#include "actuator/effects/harmonics.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

/// A parameter well inside its bounds.
double some_value(const Parameter& parameter, std::mt19937& random) {
  const double low = std::max(parameter.lowest, -0.009);
  const double high = std::min(parameter.highest, low + 3.0);
  return std::uniform_real_distribution(low + 0.1 * (high - low), high)(random);
}

Effect some_effect(const EffectKind& kind, std::mt19937& random) {
  Effect effect = neutral(kind);
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    effect.values[i] = some_value(kind.parameters[i], random);
    for (std::size_t k = 0; k < i; ++k) {
      if (kind.parameters[k].name == kind.parameters[i].at_least) {
        effect.values[i] += effect.values[k];
      }
    }
  }
  if (kind.has_harmonics) {
    std::uniform_real_distribution uniform(0.1, 1.0);
    for (const double order : {1.0, 7.0}) {
      effect.harmonics.push_back({order, uniform(random), uniform(random)});
    }
  }
  return effect;
}

Instant some_instant(std::mt19937& random) {
  std::uniform_real_distribution uniform(0.2, 2.0);
  std::bernoulli_distribution coin;
  const auto signed_value = [&] { return uniform(random) * (coin(random) ? 1.0 : -1.0); };
  Instant at;
  at.speed_rad_s = signed_value();
  at.direction = std::copysign(1.0, at.speed_rad_s);
  at.acceleration_rad_s2 = signed_value();
  at.load_torque_Nm = signed_value();
  at.current_A = signed_value();
  at.bus_current_A = signed_value();
  at.output_angle_rad = signed_value();
  at.motor_angle_rad = signed_value();
  at.winding_temperature_K = 298.15 + 40.0 * uniform(random);
  at.twist_rad = 5.0 * signed_value();
  at.twist_rate_rad_s = signed_value();
  at.input = signed_value();
  at.state = 0.1 * signed_value();
  return at;
}

// A neutral effect changes nothing: no torque, or a factor of one.
TEST(Effects, ChangeNothingAtTheirNeutralParameters) {
  std::mt19937 random(2);
  for (const EffectKind* kind : effect_library()) {
    const Effect effect = neutral(*kind);
    for (int repetition = 0; repetition < 20; ++repetition) {
      Instant at = some_instant(random);
      at.twist_rad = at.twist_rate_rad_s = 0.0;  // backlash and compliance: nothing is twisted
      if (!kind->state.empty()) at.state = kind->name == "torque_lag" ? at.input : 0.0;
      const bool is_factor = kind->acts == Acts::kTorqueFactor || kind->acts == Acts::kFluxFactor ||
                             kind->acts == Acts::kResistanceFactor ||
                             kind->acts == Acts::kDragFactor;
      EXPECT_EQ(kind->law(effect, at), is_factor ? 1.0 : 0.0) << kind->name;
    }
  }
}

// Drag takes energy out of every motion.
TEST(Effects, OfDragOpposeTheMotion) {
  std::mt19937 random(3);
  for (const EffectKind* kind : effect_library()) {
    const bool is_drag = kind->acts == Acts::kDrag || kind->acts == Acts::kLoadFriction;
    if (!is_drag || kind->has_harmonics) continue;
    for (int repetition = 0; repetition < 50; ++repetition) {
      const Effect effect = some_effect(*kind, random);
      const Instant at = some_instant(random);
      EXPECT_LT(kind->law(effect, at) * at.direction, 0.0) << kind->name;
    }
  }
}

TEST(Effects, AreNamedOnceWithNeutralValuesInBounds) {
  std::set<std::string_view> names;
  for (const EffectKind* kind : effect_library()) {
    EXPECT_TRUE(names.insert(kind->name).second) << kind->name;
    EXPECT_EQ(kind->state_rate == nullptr, kind->state.empty()) << kind->name;
    for (const Parameter& parameter : kind->parameters) {
      EXPECT_LE(parameter.lowest, parameter.neutral) << kind->name << " " << parameter.name;
      EXPECT_GE(parameter.highest, parameter.neutral) << kind->name << " " << parameter.name;
    }
  }
}

/// The cells of a line of a table, without the blanks around them.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    cells.push_back(cell.substr(1, cell.size() - 2));
  }
  return cells;
}

/// A list in backquotes as the table writes it.
std::string quoted(std::string_view name) { return fmt::format("`{}`", name); }

// Oracle: docs/effects.md, written for the user from the contract's list: the same effects, each
// with the same parameters and the same sentence.
TEST(Effects, AreThoseOfTheDocumentation) {
  std::map<std::string, std::vector<std::string>> documented;
  std::ifstream file(TORQUEWRIGHT_SOURCE_DIR "/docs/effects.md");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), 5u) << line;
    EXPECT_TRUE(documented.emplace(cells[0], std::vector{cells[2], cells[3]}).second) << line;
  }
  std::map<std::string, std::vector<std::string>> known;
  for (const EffectKind* kind : effect_library()) {
    std::vector<std::string> parameters;
    for (const Parameter& parameter : kind->parameters)
      parameters.push_back(quoted(parameter.name));
    if (kind->has_harmonics) parameters.push_back(quoted("harmonics"));
    if (kind->may_be_proportional) parameters.push_back(quoted("proportional"));
    known[quoted(kind->name)] = {fmt::format("{}", fmt::join(parameters, ", ")),
                                 std::string(kind->sentence)};
  }
  EXPECT_EQ(documented, known);
}

// Oracles: closed forms. A power's ratios, its special cases at powers 0, 1 and 2, the line that it
// is below 1 mrad/s; it takes power in either direction.
TEST(PowerLawDrag, IsAPowerOfTheSpeedAndALineNextToRest) {
  const auto torque_Nm = [](double exponent, double speed_rad_s) {
    const Effect drag = effect("power_law_drag", {0.4, exponent});
    Instant at;
    at.speed_rad_s = speed_rad_s;
    at.direction = speed_rad_s == 0.0 ? 0.0 : std::copysign(1.0, speed_rad_s);
    return drag.kind->law(drag, at);
  };
  for (const double speed : {0.002, 1.0, 7.0, 300.0}) {
    EXPECT_DOUBLE_EQ(torque_Nm(0.0, speed), -0.4);
    EXPECT_DOUBLE_EQ(torque_Nm(1.0, speed), -0.4 * speed);
    EXPECT_DOUBLE_EQ(torque_Nm(2.0, speed), -0.4 * speed * speed);
    EXPECT_NEAR(torque_Nm(0.7, 2.0 * speed) / torque_Nm(0.7, speed), std::exp2(0.7), 1e-12);
    EXPECT_DOUBLE_EQ(torque_Nm(0.7, -speed), -torque_Nm(0.7, speed));
  }
  EXPECT_EQ(torque_Nm(0.7, 0.0), 0.0);
  EXPECT_NEAR(torque_Nm(0.7, 5e-4), 0.5 * torque_Nm(0.7, 1e-3), 1e-15);
}

// Oracles: closed forms. The slope at rest is 2 T/w_c; the drag peaks at w_c, and is the same at
// w_c x and w_c / x; whatever the speed it takes power.
TEST(EddyCurrentDrag, RisesToItsPeakAndFallsBeyond) {
  const double peak_Nm = 3.0, critical_rad_s = 20.0;
  const Effect drag = effect("eddy_current_drag", {peak_Nm, critical_rad_s});
  const auto at_speed = [&](double speed_rad_s) {
    Instant at;
    at.speed_rad_s = speed_rad_s;
    return drag.kind->law(drag, at);
  };
  // Of the slope, w^2 / w_c^2 is missing.
  EXPECT_NEAR(at_speed(1e-6) / 1e-6, -2.0 * peak_Nm / critical_rad_s, 1e-12);
  EXPECT_DOUBLE_EQ(at_speed(critical_rad_s), -peak_Nm);
  for (const double ratio : {1e-3, 0.3, 0.99, 1.01, 4.0, 1e3}) {
    const double torque_Nm = at_speed(ratio * critical_rad_s);
    EXPECT_GT(torque_Nm, -peak_Nm) << ratio;
    EXPECT_LT(torque_Nm, 0.0) << ratio;
    EXPECT_DOUBLE_EQ(at_speed(-ratio * critical_rad_s), -torque_Nm) << ratio;
    EXPECT_NEAR(at_speed(critical_rad_s / ratio), torque_Nm, 1e-15 * peak_Nm) << ratio;
  }
  EXPECT_EQ(at_speed(0.0), 0.0);
}

// Oracle: Hooke's law about the angle at which it is relaxed.
TEST(ParallelSpring, PullsToItsNeutralAngle) {
  const Effect spring = effect("parallel_spring", {40.0, 0.25});
  Instant at;
  for (const double angle_rad : {-1.0, 0.0, 0.25, 2.0}) {
    at.output_angle_rad = angle_rad;
    EXPECT_DOUBLE_EQ(spring.kind->law(spring, at), 40.0 * (0.25 - angle_rad));
  }
}

// Oracle: Hooke's law beyond the stop, nothing before it.
TEST(EndStops, PushBackBeyondTheirAngleOnly) {
  const Effect upper = effect("upper_end_stop", {40.0, 0.25});
  const Effect lower = effect("lower_end_stop", {40.0, -0.5});
  const auto torques = [&](double angle_rad) {
    Instant at;
    at.output_angle_rad = angle_rad;
    return std::pair(upper.kind->law(upper, at), lower.kind->law(lower, at));
  };
  EXPECT_EQ(torques(0.0), std::pair(0.0, 0.0));
  EXPECT_EQ(torques(0.75), std::pair(-20.0, 0.0));
  EXPECT_EQ(torques(-0.75), std::pair(0.0, 10.0));
}

// Oracle: Dahl's closed form for motion at constant speed from rest: F = c (1 - exp(-sigma x / c)).
TEST(PreslidingFriction, FollowsDahlsClosedForm) {
  const Effect friction = effect("presliding_friction", {2.0, 100.0});
  Instant at;
  at.speed_rad_s = 0.5;
  at.direction = 1.0;
  const int steps = 20000;
  const double step_s = 0.1 / steps;
  for (int i = 0; i < steps; ++i) {  // midpoint rule: error of order step^2
    const double half = at.state + 0.5 * step_s * friction.kind->state_rate(friction, at);
    Instant middle = at;
    middle.state = half;
    at.state += step_s * friction.kind->state_rate(friction, middle);
  }
  EXPECT_NEAR(at.state, 2.0 * (1.0 - std::exp(-100.0 * 0.05 / 2.0)), 1e-7);
}

constexpr double kAmplitude_Nm = 3.0;
constexpr double kTurn_rad = 0.002;

/// Torque over twist of a strain-wave gear's hysteresis, turned back and forth by so much.
struct TwistedTrain {
  Effect effect =
      torquewright::actuator::effect("strain_wave_hysteresis", {kAmplitude_Nm, kTurn_rad});
  Instant at;

  double torque_Nm() const { return effect.kind->law(effect, at); }

  /// By the midpoint rule, in steps of even length; returns the work.
  double turn(double by_rad, double speed_rad_s, int steps) {
    at.twist_rate_rad_s = std::copysign(speed_rad_s, by_rad);
    const double step_s = std::abs(by_rad) / speed_rad_s / steps;
    double work_J = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double before_Nm = torque_Nm();
      Instant middle = at;
      middle.state += 0.5 * step_s * effect.kind->state_rate(effect, at);
      at.state += step_s * effect.kind->state_rate(effect, middle);
      work_J += 0.5 * (before_Nm + torque_Nm()) * at.twist_rate_rad_s * step_s;
    }
    return work_J;
  }

  /// Of the twentieth cycle between -amplitude and amplitude: by then it repeats.
  double loop_J(double amplitude_rad, double speed_rad_s, int steps) {
    turn(amplitude_rad, speed_rad_s, steps);
    double work_J = 0.0;
    for (int cycle = 0; cycle < 20; ++cycle) {
      work_J = turn(-2.0 * amplitude_rad, speed_rad_s, 2 * steps) +
               turn(2.0 * amplitude_rad, speed_rad_s, 2 * steps);
    }
    return work_J;
  }
};

// Oracle: the loop's area in closed form, 4 Z (X - s m + s m^3 / 15) with m = tanh(X / s)
// (docs/derivations/strain_wave_hysteresis.md eq. (4)), and the rule's order: half the step, a
// quarter of the error.
TEST(StrainWaveHysteresis, LosesTheAreaOfItsLoop) {
  for (const double amplitude_rad : {0.2 * kTurn_rad, kTurn_rad, 5.0 * kTurn_rad}) {
    const double m = std::tanh(amplitude_rad / kTurn_rad);
    const double area_J =
        4.0 * kAmplitude_Nm * (amplitude_rad - kTurn_rad * (m - m * m * m / 15.0));
    const double coarse_J = TwistedTrain().loop_J(amplitude_rad, 0.1, 200) - area_J;
    const double fine_J = TwistedTrain().loop_J(amplitude_rad, 0.1, 400) - area_J;
    EXPECT_NEAR(coarse_J / fine_J, 4.0, 0.2) << amplitude_rad;
    EXPECT_LT(std::abs(fine_J), 1e-3 * area_J) << amplitude_rad;
  }
}

// Oracle: twice the speed is the same loop, to the rounding of the steps' lengths.
TEST(StrainWaveHysteresis, DoesNotKnowTheSpeed) {
  const double slow_J = TwistedTrain().loop_J(kTurn_rad, 0.1, 200);
  EXPECT_NEAR(TwistedTrain().loop_J(kTurn_rad, 0.2, 200), slow_J, 1e-12 * slow_J);
}

// Oracle: what was put in is stored, Z s (3 u^2 - u^4 / 4) / 5, or lost; what is lost never
// becomes less (eq. (3)). The rule's error stays below a thousandth of what one turn costs.
TEST(StrainWaveHysteresis, NeverGivesBackMoreThanItStores) {
  TwistedTrain train;
  double put_in_J = 0.0, lost_J = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double by_rad = kTurn_rad * (1.5 * std::sin(1.7 * i) + std::sin(0.31 * i));
    put_in_J += train.turn(by_rad, 0.1, 200);
    const double u2 = train.at.state * train.at.state;
    const double stored_J = kAmplitude_Nm * kTurn_rad * (3.0 * u2 - 0.25 * u2 * u2) / 5.0;
    EXPECT_GE(put_in_J - stored_J, lost_J - 1e-3 * kAmplitude_Nm * kTurn_rad);
    lost_J = put_in_J - stored_J;
  }
  EXPECT_GT(lost_J, 0.0);
}

// Oracle: no friction of a joint that turns on: at an even twist it costs nothing, where Dahl's
// takes its level for as long as the output moves.
TEST(StrainWaveHysteresis, TakesNothingOfAnEvenMotion) {
  TwistedTrain train;
  train.turn(kTurn_rad, 0.1, 100);
  const double held_Nm = train.torque_Nm();
  train.at.twist_rate_rad_s = 0.0;
  train.at.speed_rad_s = 2.0;
  train.at.direction = 1.0;
  EXPECT_EQ(train.effect.kind->state_rate(train.effect, train.at), 0.0);
  EXPECT_EQ(train.torque_Nm(), held_Nm);
}

// Oracle: a branch that turns back from far outside begins as steeply as the first one; with Dahl's
// torque, in proportion to the state, it would begin twice as steeply.
TEST(StrainWaveHysteresis, TurnsBackAsSteeplyAsItBegan) {
  constexpr double kShort_rad = 1e-5 * kTurn_rad;
  TwistedTrain first;
  first.turn(kShort_rad, 0.1, 1);
  TwistedTrain back;
  back.turn(40.0 * kTurn_rad, 0.1, 20000);
  const double before_Nm = back.torque_Nm();
  back.turn(-kShort_rad, 0.1, 1);
  // The slope changes by a share of the way over s.
  EXPECT_NEAR((before_Nm - back.torque_Nm()) / first.torque_Nm(), 1.0, 1e-4);
}

// Oracle: half the play lies on either side. Without play everything is beyond it.
TEST(Backlash, IsTheTwistBeyondHalfTheGap) {
  Instant at;
  for (const double sign : {1.0, -1.0}) {
    at.twist_rad = sign * 0.3;
    const Effect play = effect("backlash", {0.2});
    EXPECT_DOUBLE_EQ(play.kind->law(play, at), sign * 0.2);
    const Effect none = neutral(*play.kind);
    EXPECT_DOUBLE_EQ(none.kind->law(none, at), sign * 0.3);
    at.twist_rad = sign * 0.09;
    EXPECT_EQ(play.kind->law(play, at), 0.0);
  }
}

// Oracle: the lag's equation tau dT/dt = asked - T, and none without a time constant.
TEST(TorqueLag, FollowsByItsTimeConstant) {
  Instant at;
  at.input = 5.0;
  at.state = 2.0;
  const Effect lag = effect("torque_lag", {0.25});
  EXPECT_DOUBLE_EQ(lag.kind->state_rate(lag, at), 12.0);
  const Effect none = effect("torque_lag", {0.0});
  EXPECT_EQ(none.kind->state_rate(none, at), 0.0);
}

// Oracle: for a slow sum of sines the extremes are found on a grid 1000 times finer.
TEST(HarmonicRange, HoldsEveryAngleAndIsTight) {
  const std::vector<Harmonic> waves{{1.0, 0.7, 0.3}, {3.0, 0.5, -1.0}, {12.0, 0.2, 2.0}};
  const HarmonicRange range = harmonic_range(waves);
  double smallest = 0.0;
  double largest = 0.0;
  for (int i = 0; i < 768000; ++i) {
    const double value = harmonic_sum(waves, 2.0 * 3.14159265358979323846 * i / 768000.0);
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
  }
  EXPECT_LE(range.smallest, smallest);
  EXPECT_GE(range.largest, largest);
  // The allowance is curvature h^2 / 8 with h = 2 pi/768.
  const double allowance =
      (0.7 + 0.5 * 9.0 + 0.2 * 144.0) * std::pow(2.0 * 3.1416 / 768.0, 2) / 4.0;
  EXPECT_NEAR(range.largest, largest, allowance);
}

TEST(HarmonicRange, OfOrdersThatNeverMeetIsTheSumOfAmplitudes) {
  const HarmonicRange range =
      harmonic_range(std::vector<Harmonic>{{1.0, 1.0, 0.0}, {1.5, 2.0, 0.0}});
  EXPECT_EQ(range.largest, 3.0);
  EXPECT_EQ(range.smallest, -3.0);
}

TEST(EffectSpec, ReadsBackWhatItWrites) {
  std::mt19937 random(4);
  for (const EffectKind* kind : effect_library()) {
    const Effect written = some_effect(*kind, random);
    std::vector<io::Fault> faults;
    const nlohmann::json entry = nlohmann::json::parse(effect_json(written).dump());
    const std::optional<Effect> read = read_effect(entry, "f", "/effects/0", faults);
    ASSERT_TRUE(read) << (faults.empty() ? "" : faults.front().message);
    EXPECT_EQ(read->kind, written.kind);
    EXPECT_EQ(read->values, written.values);
    EXPECT_EQ(read->harmonics.size(), written.harmonics.size());
  }
}

// Just inside and just outside.
TEST(EffectSpec, RefusesOrdersThatAreNone) {
  for (const double order : {0.0, 1e-3, 10000.0, 10000.1}) {
    std::vector<io::Fault> faults;
    const nlohmann::json wave = {{"order", order}, {"amplitude_Nm", 0.1}, {"phase_rad", 0.0}};
    read_effect({{"effect", "cogging_torque"}, {"parameters", {{"harmonics", {wave}}}}}, "f",
                "/effects/0", faults);
    EXPECT_EQ(faults.empty(), order > 0.0 && order <= 10000.0)
        << order << (faults.empty() ? "" : faults[0].message);
  }
}

TEST(EffectSpec, NamesTheNearestEffectAndTheMissingParameter) {
  std::vector<io::Fault> faults;
  read_effect({{"effect", "coulomb_fricton"}, {"parameters", nlohmann::json::object()}}, "f",
              "/effects/0", faults);
  read_effect({{"effect", "coulomb_friction"}, {"parameters", {{"coulomb", 1.0}}}}, "f",
              "/effects/1", faults);
  read_effect({{"effect", "stribeck_friction"},
               {"parameters",
                {{"coulomb_Nm", 2.0}, {"breakaway_Nm", 1.0}, {"stribeck_velocity_rad_s", 0.1}}}},
              "f", "/effects/2", faults);
  ASSERT_EQ(faults.size(), 4u);
  EXPECT_NE(faults[0].message.find("did you mean \"coulomb_friction\""), std::string::npos);
  EXPECT_EQ(faults[1].path, "/effects/1/parameters/coulomb");
  EXPECT_EQ(faults[2].path, "/effects/1/parameters/coulomb_Nm");
  EXPECT_EQ(faults[3].path, "/effects/2/parameters/breakaway_Nm");
}

}  // namespace
}  // namespace torquewright::actuator
