// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracles/bench_log/harmonics.hpp"

namespace torquewright::oracles {

/// What kind of log is drawn.
enum class LogClass {
  kNone,        ///< The nominal actuator is true: nothing is missing.
  kOne,         ///< One undeclared effect, excited so that it can be told.
  kTwo,         ///< Two undeclared effects that can be told apart.
  kCannotTell,  ///< An effect in data that cannot tell it from others.
  kOutside,     ///< Something that is no effect of the library.
  kShort,       ///< One effect, two runs of 5 to 8 s.
};

/// An effect that is in the log and not in the nominal actuator, the rig or the columns.
struct TrueEffect {
  std::string effect;  ///< Its name in the contract.
  std::string family;  ///< actuator, rig or log.
  std::map<std::string, double> parameters;
  std::vector<Harmonic> harmonics;  ///< Of cogging, ripple, position-dependent friction.
  bool proportional = false;        ///< Ripple: amplitudes are ratios of the load.
  std::string channel;              ///< Of a channel_delay.
  /// For values that the rig lists as uncertain: pointer into the document, true value. (The
  /// parameter `value` of the same effect is true less stated.)
  std::map<std::string, double> corrected;
  /// The residual it changes: torque (N m at the output; N on a linear axis), kinematic (rad),
  /// electrical (V), bus (V) or velocity (rad/s).
  std::string equation = "torque";
  double residual_rms = 0.0;    ///< What it adds to that residual, in the band, all runs together.
  double noise_multiple = 0.0;  ///< The same over the noise floor of that residual.
  /// Names that are the same column on this rig whatever the excitation; itself first.
  std::vector<std::string> same_as;
};

/// White noise (standard deviation per sample) and resolution put into a column.
struct ChannelNoise {
  std::string quantity;
  double sigma = 0.0;
  double resolution = 0.0;  ///< 0: not quantised.
};

struct Truth {
  LogClass log_class = LogClass::kNone;
  std::vector<TrueEffect> effects;
  /// kOutside: its name, and the coordinates an honest report would name, any of them right:
  /// quantities of the contract, or time_s, time_since_reversal, electrical_angle.
  std::string phenomenon;
  std::vector<std::string> coordinates;
  double phenomenon_rms = 0.0;  ///< What it adds to the residual of torque, in the band.
  /// kCannotTell: names that may stand in the confounded group; nothing else may, and none of them
  /// alone as certain. Empty for other classes.
  std::vector<std::string> acceptable;
  std::string situation;  ///< kCannotTell: one_speed, constant_load, ...
  std::vector<ChannelNoise> noise;
  std::array<double, 2> band_hz{0.0, 8.0};
  /// Per equation: rms, in the band, of the noise that the channels put into its residual.
  std::map<std::string, double> noise_floor_rms;
};

struct LogRun {
  std::string name;
  std::vector<std::vector<double>> columns;  ///< One for each of MeasuredLog::columns.
};

struct MeasuredLog {
  std::vector<std::string> columns;  ///< Without the run's name. time first.
  std::vector<LogRun> runs;
};

/// What a laboratory would hand over, and the truth behind it.
struct Scenario {
  std::string name;  ///< Class, effects, seed: for messages.
  std::uint64_t seed = 0;
  bool one_file = true;  ///< One CSV with a `run` column; else one per run, the stem its name.
  MeasuredLog log;
  nlohmann::json rig;       ///< Document of kind rig.
  nlohmann::json actuator;  ///< Document of kind actuator: the nominal one.
  Truth truth;
};

/// The same seed gives the same scenario everywhere. Seeds of one class run through its effects or
/// situations in turn: `count` seeds in a row spread evenly over them.
Scenario draw(LogClass log_class, std::uint64_t seed);

/// kOne with this effect of the contract; throws std::invalid_argument for other names.
Scenario draw_effect(const std::string& effect, std::uint64_t seed);

/// A pendulum with one encoder and friction that is declared, and what a regression over its
/// motion cannot show: nothing; backlash_output_encoder and backlash_motor_encoder (the position is
/// known on one side of the gap only); breakaway (friction at rest exceeds that in motion, in slow
/// stick and slip); standstill (friction that mostly holds). Throws std::invalid_argument for other
/// names.
Scenario draw_blind(const std::string& situation, std::uint64_t seed);

/// The names that kOne runs through, in the contract's order.
const std::vector<std::string>& drawn_effects();

/// none, one, two, cannot_tell, outside, short.
const char* name_of(LogClass log_class);

struct ScenarioFiles {
  std::vector<std::filesystem::path> logs;
  std::filesystem::path rig, actuator, truth;
};

/// Writes log.csv (or one CSV per run), rig.json, actuator.json and truth.json into the folder,
/// which is made where it is missing. The identification is to see all but truth.json.
ScenarioFiles write_scenario(const std::filesystem::path& folder, const Scenario& scenario);

}  // namespace torquewright::oracles
