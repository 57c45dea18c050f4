// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/column_guess.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>

#include "io/text/letter_case.hpp"

namespace torquewright::identification {
namespace {

using io::Dimension;

/// What a word of a column's name says.
enum class Says {
  kTime,
  kRun,
  kEnabled,
  kPosition,
  kVelocity,
  kCurrent,
  kTorque,
  kForce,
  kVoltage,
  kDuty,
  kTemperature,
  kCommanded,
  kMotorSide,
  kOutputSide,
  kSensor,
  kReported,
  kFeedforward,
  kBus,
  kWinding,
  kCase,
  kElectronics,
};

struct Word {
  std::string_view word;
  Says says;
};

constexpr Word kWords[] = {
    {"t", Says::kTime},
    {"time", Says::kTime},
    {"timestamp", Says::kTime},
    {"stamp", Says::kTime},
    {"clock", Says::kTime},
    {"zeit", Says::kTime},
    {"zeitstempel", Says::kTime},
    {"run", Says::kRun},
    {"trial", Says::kRun},
    {"episode", Says::kRun},
    {"segment", Says::kRun},
    {"experiment", Says::kRun},
    {"enabled", Says::kEnabled},
    {"enable", Says::kEnabled},
    {"q", Says::kPosition},
    {"pos", Says::kPosition},
    {"position", Says::kPosition},
    {"angle", Says::kPosition},
    {"theta", Says::kPosition},
    {"encoder", Says::kPosition},
    {"ang", Says::kPosition},
    {"winkel", Says::kPosition},
    {"qd", Says::kVelocity},
    {"dq", Says::kVelocity},
    {"qdot", Says::kVelocity},
    {"vel", Says::kVelocity},
    {"velocity", Says::kVelocity},
    {"speed", Says::kVelocity},
    {"omega", Says::kVelocity},
    {"drehzahl", Says::kVelocity},
    {"i", Says::kCurrent},
    {"iq", Says::kCurrent},
    {"current", Says::kCurrent},
    {"cur", Says::kCurrent},
    {"strom", Says::kCurrent},
    {"tau", Says::kTorque},
    {"torque", Says::kTorque},
    {"trq", Says::kTorque},
    {"effort", Says::kTorque},
    {"moment", Says::kTorque},
    {"drehmoment", Says::kTorque},
    {"force", Says::kForce},
    {"v", Says::kVoltage},
    {"u", Says::kVoltage},
    {"voltage", Says::kVoltage},
    {"volt", Says::kVoltage},
    {"spannung", Says::kVoltage},
    {"duty", Says::kDuty},
    {"pwm", Says::kDuty},
    {"temp", Says::kTemperature},
    {"temperature", Says::kTemperature},
    {"temperatur", Says::kTemperature},
    {"cmd", Says::kCommanded},
    {"command", Says::kCommanded},
    {"commanded", Says::kCommanded},
    {"des", Says::kCommanded},
    {"desired", Says::kCommanded},
    {"ref", Says::kCommanded},
    {"reference", Says::kCommanded},
    {"goal", Says::kCommanded},
    {"target", Says::kCommanded},
    {"setpoint", Says::kCommanded},
    {"ff", Says::kFeedforward},
    {"feedforward", Says::kFeedforward},
    {"motor", Says::kMotorSide},
    {"rotor", Says::kMotorSide},
    {"output", Says::kOutputSide},
    {"joint", Says::kOutputSide},
    {"sensor", Says::kSensor},
    {"measured", Says::kSensor},
    {"meas", Says::kSensor},
    {"loadcell", Says::kSensor},
    {"est", Says::kReported},
    {"estimate", Says::kReported},
    {"estimated", Says::kReported},
    {"reported", Says::kReported},
    {"bus", Says::kBus},
    {"vbus", Says::kBus},
    {"battery", Says::kBus},
    {"vbat", Says::kBus},
    {"supply", Says::kBus},
    {"dc", Says::kBus},
    {"winding", Says::kWinding},
    {"coil", Says::kWinding},
    {"case", Says::kCase},
    {"housing", Says::kCase},
    {"fet", Says::kElectronics},
    {"mosfet", Says::kElectronics},
    {"inverter", Says::kElectronics},
    {"driver", Says::kElectronics},
    {"esc", Says::kElectronics},
    {"board", Says::kElectronics},
    {"pcb", Says::kElectronics},
    {"mcu", Says::kElectronics},
    {"ambient", Says::kElectronics},
};

const Word* find_word(std::string_view text) {
  const std::string small = io::in_small_letters(std::string(text));
  const auto* found = std::find_if(std::begin(kWords), std::end(kWords),
                                   [&](const Word& each) { return each.word == small; });
  return found == std::end(kWords) ? nullptr : found;
}

/// What the words of a name say, and those that say nothing known.
struct Reading {
  std::vector<Says> says;
  std::vector<std::string> known, left;

  bool has(Says what) const { return std::find(says.begin(), says.end(), what) != says.end(); }
  bool has_any(std::initializer_list<Says> of) const {
    return std::any_of(of.begin(), of.end(), [this](Says each) { return has(each); });
  }
};

Reading read(const std::vector<std::string>& words) {
  Reading reading;
  for (const std::string& each : words) {
    const Word* word = find_word(each);
    if (word == nullptr) {
      reading.left.push_back(each);
      continue;
    }
    reading.says.push_back(word->says);
    reading.known.push_back(each);
  }
  return reading;
}

/// The kind of quantity that a dimension is of; none where a number has no unit.
std::optional<Says> kind_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::kTime:
      return Says::kTime;
    case Dimension::kAngle:
    case Dimension::kLength:
      return Says::kPosition;
    case Dimension::kAngularVelocity:
    case Dimension::kVelocity:
      return Says::kVelocity;
    case Dimension::kTorque:
      return Says::kTorque;
    case Dimension::kForce:
      return Says::kForce;
    case Dimension::kCurrent:
      return Says::kCurrent;
    case Dimension::kVoltage:
      return Says::kVoltage;
    case Dimension::kTemperature:
      return Says::kTemperature;
    default:
      return std::nullopt;
  }
}

/// The kind that the name says: the last word that names one ("motor current", "bus voltage").
std::optional<Says> kind_of(const Reading& reading) {
  for (auto each = reading.says.rbegin(); each != reading.says.rend(); ++each) {
    if (*each <= Says::kTemperature) return *each;
  }
  if (reading.has(Says::kBus)) return Says::kVoltage;
  return std::nullopt;
}

std::optional<Quantity> position_of(const Reading& by, bool is_linear) {
  if (is_linear)
    return by.has(Says::kCommanded) ? std::nullopt : std::optional(Quantity::kLinearPosition);
  if (by.has(Says::kCommanded)) return Quantity::kCommandedPosition;
  return by.has(Says::kMotorSide) ? Quantity::kMotorPosition : Quantity::kOutputPosition;
}

std::optional<Quantity> velocity_of(const Reading& by, bool is_linear) {
  if (by.has(Says::kCommanded)) return std::nullopt;
  if (is_linear) return Quantity::kLinearVelocity;
  return by.has(Says::kMotorSide) ? Quantity::kMotorVelocity : Quantity::kOutputVelocity;
}

Quantity torque_of(const Reading& by) {
  if (by.has(Says::kFeedforward)) return Quantity::kFeedforwardTorque;
  if (by.has(Says::kCommanded)) return Quantity::kCommandedTorque;
  return by.has(Says::kReported) ? Quantity::kReportedTorque : Quantity::kOutputTorque;
}

std::optional<Quantity> quantity_of(Says kind, const Reading& by, bool is_linear) {
  switch (kind) {
    case Says::kTime:
      return Quantity::kTime;
    case Says::kRun:
      return Quantity::kRun;
    case Says::kEnabled:
      return Quantity::kEnabled;
    case Says::kPosition:
      return position_of(by, is_linear);
    case Says::kVelocity:
      return velocity_of(by, is_linear);
    case Says::kTorque:
      return torque_of(by);
    case Says::kForce:
      return by.has(Says::kCommanded) ? std::nullopt : std::optional(Quantity::kLinearForce);
    case Says::kCurrent:
      return by.has_any({Says::kCommanded, Says::kBus}) ? std::nullopt
                                                        : std::optional(Quantity::kMotorCurrent);
    case Says::kVoltage:
      return by.has(Says::kBus) ? Quantity::kBusVoltage : Quantity::kWindingVoltage;
    case Says::kDuty:
      return Quantity::kDuty;
    case Says::kTemperature:
      if (by.has(Says::kElectronics)) return std::nullopt;
      return by.has(Says::kCase) ? Quantity::kCaseTemperature : Quantity::kWindingTemperature;
    default:
      return std::nullopt;
  }
}

/// Whether a unit may stand at a quantity.
bool is_unit_of(const std::optional<io::Unit>& unit, Quantity quantity) {
  const std::optional<io::Unit> own = io::find_unit(unit_of(quantity));
  return unit && own && unit->dimension == own->dimension;
}

std::string words_text(const Reading& reading, const std::optional<io::Unit>& unit) {
  std::string text;
  if (!reading.known.empty()) text = fmt::format("by \"{}\"", fmt::join(reading.known, " "));
  if (unit) text += fmt::format("{}{}", text.empty() ? "by its unit " : " in ", unit->name);
  return text;
}

bool is_count(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& each) {
    const std::string small = io::in_small_letters(each);
    return small == "counts" || small == "ticks" || small == "cnt" || small == "lsb";
  });
}

}  // namespace

ColumnGuess guess_by_name(const std::string& column, const std::string& unit_below) {
  const ColumnWords parts = words_of(column, unit_below);
  const Reading reading = read(parts.words);
  ColumnGuess guess;
  guess.column = column;
  guess.joint = fmt::format("{}", fmt::join(reading.left, "_"));
  const std::optional<Says> by_words = kind_of(reading);
  const std::optional<Says> by_unit = parts.unit ? kind_of(parts.unit->dimension) : std::nullopt;
  const std::optional<Says> kind = by_unit ? by_unit : by_words;
  if (!kind) {
    guess.why =
        is_count(parts.words)
            ? "counts are no angle; a quantity with \"scale\" (the rad of one count) reads them"
            : "its name says no quantity of a rig";
    return guess;
  }
  const bool is_linear = parts.unit && (parts.unit->dimension == Dimension::kLength ||
                                        parts.unit->dimension == Dimension::kVelocity);
  guess.quantity = quantity_of(*kind, reading, is_linear);
  if (!guess.quantity) {
    guess.why = words_text(reading, parts.unit) + ": a rig has no such quantity";
    return guess;
  }
  if (is_unit_of(parts.unit, *guess.quantity)) guess.unit = parts.unit;
  guess.why = words_text(reading, guess.unit);
  const bool needs_unit = !unit_of(*guess.quantity).empty();
  const bool is_agreed = (!by_words || by_words == kind) && !parts.other && parts.ampere.empty();
  if (parts.other) {
    guess.why += fmt::format("; {} stands there too, and contradicts it", parts.other->name);
  }
  if (!parts.ampere.empty()) {
    guess.why += fmt::format("; {}: the actuator's torque constant must be per that ampere",
                             parts.ampere == "rms" ? "an rms value" : "an amplitude");
  }
  guess.is_sure = is_agreed && (guess.unit || !needs_unit);
  return guess;
}

}  // namespace torquewright::identification
