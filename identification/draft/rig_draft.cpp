// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/rig_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>

#include "identification/draft/numbers.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/letter_case.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLeastCorrelation = 0.9;
constexpr double kSameUnit = 0.15;  ///< By which a slope may miss a unit's.

/// What one supply, housing or clock states for all joints.
bool is_shared(Quantity quantity) {
  static constexpr Quantity kShared[] = {Quantity::kTime,
                                         Quantity::kRun,
                                         Quantity::kBusVoltage,
                                         Quantity::kEnabled,
                                         Quantity::kWindingTemperature,
                                         Quantity::kCaseTemperature};
  return std::find(std::begin(kShared), std::end(kShared), quantity) != std::end(kShared);
}

double in_SI(const ColumnGuess& guess) { return guess.unit ? guess.unit->in_SI : 1.0; }

class Draft {
 public:
  explicit Draft(const LogSample& sample) : sample_(sample) {
    for (std::size_t c = 0; c < sample.names.size(); ++c) {
      guesses_.push_back(guess_by_name(sample.names[c], sample.units[c]));
    }
  }

  RigDraft draft() {
    find_time();
    find_runs();
    name_joints();
    drop_doubles();
    find_units();
    find_reported_torques();
    RigDraft draft;
    draft.columns = std::move(guesses_);
    draft.joints.assign(joints_.begin(), joints_.end());
    draft.unnamed_run = unnamed_run_;
    return draft;
  }

 private:
  ColumnGuess* find(Quantity quantity, const std::string& joint) {
    const auto found = std::find_if(guesses_.begin(), guesses_.end(), [&](const ColumnGuess& each) {
      return each.quantity == quantity && (is_shared(quantity) || each.joint == joint);
    });
    return found == guesses_.end() ? nullptr : &*found;
  }
  const Series& numbers_of(const ColumnGuess& guess) const {
    return sample_.numbers[static_cast<std::size_t>(&guess - guesses_.data())];
  }

  /// The column that its name says, else the first that only grows; and its unit.
  void find_time() {
    ColumnGuess* time = find(Quantity::kTime, "");
    for (std::size_t c = 0; c < guesses_.size() && time == nullptr; ++c) {
      if (guesses_[c].quantity || !looks_like_time(sample_.numbers[c])) continue;
      time = &guesses_[c];
      time->quantity = Quantity::kTime;
      time->why = "its numbers only grow, in even steps";
    }
    if (time == nullptr || time->unit) return;
    time->unit = unit_of_time(numbers_of(*time));
    if (time->unit) time->why += fmt::format("; in {}, by its step", time->unit->name);
  }

  /// Where no name says it, the runs stand in the column that changes just where time begins again.
  void find_runs() {
    const ColumnGuess* time = find(Quantity::kTime, "");
    if (time == nullptr || find(Quantity::kRun, "") != nullptr) return;
    const std::vector<std::size_t> begins = falls_of(numbers_of(*time));
    if (begins.empty()) return;
    for (std::size_t c = 0; c < guesses_.size(); ++c) {
      if (guesses_[c].quantity || sample_.changes[c] != begins) continue;
      guesses_[c].quantity = Quantity::kRun;
      guesses_[c].why = "it changes where time begins again, and nowhere else";
      return;
    }
    unnamed_run_ = begins.front();
  }

  /// Words that are left in names tell joints apart where a quantity stands with several of them.
  void name_joints() {
    std::map<Quantity, std::set<std::string>> named;
    for (const ColumnGuess& each : guesses_) {
      if (each.quantity && !is_shared(*each.quantity)) named[*each.quantity].insert(each.joint);
    }
    for (const auto& [quantity, joints] : named) {
      if (joints.size() > 1 && joints.size() > joints_.size()) joints_ = joints;
    }
    joints_.erase("");
    for (ColumnGuess& each : guesses_) {
      if (!each.quantity || joints_.empty() || is_shared(*each.quantity)) {
        each.joint.clear();
      } else if (!joints_.contains(each.joint)) {
        ignore(each, "what is left of its name is no joint's");
      }
    }
  }

  void drop_doubles() {
    for (ColumnGuess& each : guesses_) {
      if (!each.quantity) continue;
      const ColumnGuess* first = find(*each.quantity, each.joint);
      if (first == &each) continue;
      ignore(each,
             fmt::format("{} is taken for {} already", first->column, name_of(*each.quantity)));
    }
  }

  static void ignore(ColumnGuess& guess, std::string why) {
    guess.quantity.reset();
    guess.joint.clear();
    guess.why = std::move(why);
  }

  void find_units() {
    std::set<std::string> joints = joints_;
    if (joints.empty()) joints.insert("");
    for (const std::string& joint : joints) {
      find_units_of(find(Quantity::kOutputPosition, joint), find(Quantity::kOutputVelocity, joint));
      find_units_of(find(Quantity::kMotorPosition, joint), find(Quantity::kMotorVelocity, joint));
    }
  }

  void find_units_of(ColumnGuess* position, ColumnGuess* velocity) {
    if (position == nullptr) return;
    if (!position->unit) {
      position->unit = unit_by_turns(numbers_of(*position));
      if (position->unit)
        position->why += fmt::format("; in {}, by its jumps of a turn", position->unit->name);
    }
    if (velocity != nullptr) compare(*position, *velocity);
  }

  /// The one by the derivative of the other: the unit that is not stated, and the sign.
  void compare(ColumnGuess& position, ColumnGuess& velocity) {
    const ColumnGuess* time = find(Quantity::kTime, "");
    if (time == nullptr) return;
    Series time_s = numbers_of(*time);
    for (double& each : time_s) each *= in_SI(*time);
    const auto slope = slope_between(time_s, numbers_of(position), numbers_of(velocity));
    if (!slope || std::abs(slope->correlation) < kLeastCorrelation) return;
    velocity.is_reversed = slope->per_second < 0.0;
    if (velocity.is_reversed) {
      velocity.why += fmt::format("; against the sign of {}'s derivative", position.column);
    }
    const double size = std::abs(slope->per_second);
    // velocity = slope * d position / dt, each times its unit.
    if (!velocity.unit) {
      take_unit(velocity, in_SI(position) / size, {"rad/s", "deg/s", "rpm", "rev/s"}, position);
    } else if (!position.unit) {
      take_unit(position, in_SI(velocity) * size, {"rad", "deg", "rev"}, velocity);
    }
  }

  /// The unit of that size, if one is: the derivative of the one is the other then.
  static void take_unit(ColumnGuess& guess, double size, std::initializer_list<const char*> names,
                        const ColumnGuess& other) {
    for (const char* name : names) {
      const std::optional<io::Unit> unit = io::find_unit(name);
      if (std::abs(std::log(size / unit->in_SI)) > kSameUnit) continue;
      guess.unit = unit;
      guess.why += fmt::format("; in {}, by its size beside {}", name, other.column);
      return;
    }
  }

  /// A driver's torque is its current times a constant; a sensor's is not.
  void find_reported_torques() {
    for (ColumnGuess& each : guesses_) {
      if (each.quantity != Quantity::kOutputTorque) continue;
      const ColumnGuess* current = find(Quantity::kMotorCurrent, each.joint);
      const bool is_of_current =
          current != nullptr && is_multiple(numbers_of(each), numbers_of(*current));
      if (current != nullptr && !is_of_current) {
        each.why += "; taken for a sensor's, since it is no multiple of the current";
      } else {
        each.quantity = Quantity::kReportedTorque;
        each.why += current == nullptr
                        ? "; taken for the driver's own, since no current stands beside it"
                        : fmt::format("; the driver's own: {} times a constant", current->column);
      }
      each.is_sure = false;
    }
  }

  const LogSample& sample_;
  std::vector<ColumnGuess> guesses_;
  std::set<std::string> joints_;
  std::size_t unnamed_run_ = 0;
};

bool has(const RigDraft& draft, Quantity quantity) {
  return std::any_of(draft.columns.begin(), draft.columns.end(),
                     [&](const ColumnGuess& each) { return each.quantity == quantity; });
}

/// Whether a column's own name says that it is of the joint.
bool names_a_side(const RigDraft& draft) {
  return std::any_of(draft.columns.begin(), draft.columns.end(), [](const ColumnGuess& each) {
    const std::string name = io::in_small_letters(each.column);
    return name.find("joint") != name.npos || name.find("output") != name.npos;
  });
}

std::vector<std::string> what_is_open(const RigDraft& draft) {
  std::vector<std::string> open;
  if (!has(draft, Quantity::kTime)) {
    open.emplace_back(
        "No column is a time: the log is read as values that hold the actuator at positions.");
  }
  if (draft.unnamed_run > 0) {
    open.push_back(fmt::format(
        "Time begins again at row {} of the data, and no column changes just there: where runs "
        "follow one another, add a column that names them, of the quantity \"run\".",
        draft.unnamed_run + 1));
  }
  const bool has_output =
      has(draft, Quantity::kOutputPosition) || has(draft, Quantity::kOutputVelocity);
  const bool has_motor =
      has(draft, Quantity::kMotorPosition) || has(draft, Quantity::kMotorVelocity);
  if (has_output && !has_motor && !names_a_side(draft)) {
    open.emplace_back(
        "Angle and speed are taken for the output's: where the encoder sits on the rotor, the "
        "quantities are motor_position_rad and motor_velocity_rad_s.");
  }
  if (!draft.joints.empty()) {
    open.push_back(fmt::format(
        "Joints are {}: state \"load\" as a serial_arm whose links have these names, or as a robot "
        "(then \"joint\" is the robot's name of each).",
        io::listed(draft.joints)));
  } else if (!draft.is_dynamometer) {
    open.emplace_back(
        "What the actuator moved stands in no log: state \"load\" (free, pendulum, linear_axis, "
        "dynamometer).");
  }
  return open;
}

}  // namespace

RigDraft draft_rig(const std::filesystem::path& log) {
  const LogSample sample = read_sample(log);
  RigDraft draft = Draft(sample).draft();
  const bool is_any = std::any_of(draft.columns.begin(), draft.columns.end(), [](const auto& each) {
    return each.quantity && !is_shared(*each.quantity);
  });
  if (!is_any) {
    io::refuse(log.string(),
               fmt::format("none of its columns ({}) is known by its name: a rig names them, "
                           "`torquewright init rig` prints one",
                           io::listed(sample.names)));
  }
  draft.is_dynamometer = draft.joints.empty() && has(draft, Quantity::kOutputTorque);
  draft.open = what_is_open(draft);
  return draft;
}

}  // namespace torquewright::identification
