// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/explanation.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "hopper/planning/plane/sagittal_robot.hpp"
#include "hopper/planning/search/plan_search.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "hopper/variation/drive_groups.hpp"
#include "hopper/variation/variation.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {
namespace {

using Clock = std::chrono::steady_clock;

/// Of what the documents have: about twice as much from one to the next. A change below the first
/// is within what documents are wrong by; beyond the last it is another robot.
constexpr std::array kShares{0.02, 0.05, 0.1, 0.2, 0.4};
/// Of a part of the reserve, which is given up at last.
constexpr std::array kGivenUp{0.1, 0.2, 0.4, 0.7, 1.0};
static_assert(kGivenUp.size() == kShares.size());
constexpr const char* kPlace = "--explain";

/// A quantity and the way it is changed.
struct Direction {
  Variable variable;
  double sign = 1.0;                 ///< +1 up, -1 down.
  const MarginPart* part = nullptr;  ///< Of the reserve; null: something else is changed,
  bool is_speed = false;             ///< the speed that was asked for, or else the robot.

  double value(std::size_t rung) const {
    if (part == nullptr) return variable.present * (1.0 + sign * kShares[rung]);
    return std::max(PlanMargins().*part->margin, variable.present * (1.0 - kGivenUp[rung]));
  }
};

/// By its value where all its drives have the same, else as a factor.
Variable named(const Robot& robot, const std::string& name) {
  try {
    return variable_named(robot, name, kPlace);
  } catch (const io::SpecError&) {
    return variable_named(robot, name + "_factor", kPlace);
  }
}

/// The bus voltage that was asked for stands in the place of every battery's.
Variable voltage(const Robot& robot, const CheckOptions& check) {
  Variable variable = named(robot, "voltage");
  if (!check.conditions.bus_voltage_V) return variable;
  variable.present = *check.conditions.bus_voltage_V;
  variable.is_factor = false;
  variable.unit = "V";
  variable.name = "voltage";
  return variable;
}

/// Of each drivetrain that moves in the plane, all of its drives at once: one of a pair alone would
/// lead out of it. Drives of one drivetrain that no name stands for are left out.
std::vector<Variable> moved_ratios(const Robot& robot) {
  const SagittalRobot plane = sagittal(robot);
  std::vector<Variable> ratios;
  std::size_t drive = 0;
  for (const Drivetrain& drivetrain : plane.robot.drivetrains) {
    std::vector<std::size_t> drives(drivetrain.actuators.size());
    for (std::size_t& one : drives) one = drive++;
    const bool moves =
        std::any_of(drivetrain.joints.begin(), drivetrain.joints.end(), [&](std::size_t joint) {
          return std::count(plane.joints.begin(), plane.joints.end(), joint) > 0;
        });
    const std::vector<DriveGroup> groups = drive_groups(robot);
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const DriveGroup& one) { return one.drives == drives; });
    if (moves && group != groups.end()) ratios.push_back(named(robot, group->name + "_ratio"));
  }
  return ratios;
}

/// Whether the documents say what follows from such a change.
bool is_known(const Robot& robot, const Direction& direction) {
  try {
    varied(robot, direction.variable, direction.value(0));
    return true;
  } catch (const io::SpecError&) {
    return false;
  }
}

/// Less of each part that the reserve has made greater than it usually is.
std::vector<Direction> parts_of_reserve(const PlanOptions& options) {
  std::vector<Direction> directions;
  for (const MarginPart& part : margin_parts()) {
    const double margin = options.margins.*part.margin;
    const bool is_reserves = part.per_reserve > 0.0 && margin == part.per_reserve * options.reserve;
    if (!is_reserves || !is_kept(part, options) || !(margin > PlanMargins().*part.margin)) continue;
    Direction& less = directions.emplace_back(Direction{{}, -1.0, &part});
    less.variable.name = "reserve of " + std::string(part.name);
    less.variable.unit = part.unit;
    less.variable.present = margin;
  }
  return directions;
}

/// Less of the speed that hops are asked for.
Direction slower(double speed_m_s) {
  Direction less{{}, -1.0, nullptr, true};
  less.variable.name = "speed";
  less.variable.unit = "m/s";
  less.variable.present = speed_m_s;
  return less;
}

std::vector<Direction> directions_of(const Robot& robot, const PlanOptions& options) {
  std::vector<Direction> directions;
  if (options.speed_m_s) directions.push_back(slower(*options.speed_m_s));
  for (Direction& part : parts_of_reserve(options)) directions.push_back(std::move(part));
  directions.push_back({voltage(robot, options.check), 1.0});
  directions.push_back({named(robot, "current"), 1.0});
  for (const Variable& ratio : moved_ratios(robot)) {
    directions.push_back({ratio, -1.0});
    directions.push_back({ratio, 1.0});
  }
  directions.push_back({named(robot, "mass"), -1.0});
  std::erase_if(directions, [&](const Direction& one) {
    return one.part == nullptr && !one.is_speed && !is_known(robot, one);
  });
  return directions;
}

/// Searches, one after the other.
class Attempts {
 public:
  Attempts(const Robot& robot, const PlanOptions& options) : robot_(robot), options_(options) {
    options_.explain = false;
  }

  /// By the deadline; marked as cut off where there is no answer by then.
  ChangeTried smallest(const Direction& direction, Clock::time_point deadline) const;

 private:
  /// Whether there is a plan; none: the deadline, or Ctrl-C, came first.
  std::optional<bool> has_plan(const Direction& direction, double value,
                               Clock::time_point deadline) const;
  bool is_stopped() const { return options_.should_stop && options_.should_stop(); }

  const Robot& robot_;
  PlanOptions options_;
};

std::optional<bool> Attempts::has_plan(const Direction& direction, double value,
                                       Clock::time_point deadline) const {
  const Variable& variable = direction.variable;
  const std::chrono::duration<double> left = deadline - Clock::now();
  if (left.count() <= 0.0 || is_stopped()) return std::nullopt;
  PlanOptions options = options_;
  options.most_seconds = left.count();
  if (direction.part != nullptr) options.margins.*direction.part->margin = value;
  if (direction.is_speed) options.speed_m_s = value;
  std::optional<double>& bus_voltage_V = options.check.conditions.bus_voltage_V;
  const bool is_stated = direction.part != nullptr || direction.is_speed;
  const bool is_of_bus = !is_stated && variable.quantity == Quantity::kVoltage && bus_voltage_V;
  if (is_of_bus) bus_voltage_V = value;
  const bool is_of_robot = !is_stated && !is_of_bus;
  try {
    const Robot changed = is_of_robot ? varied(robot_, variable, value) : robot_;
    const PlanStatus status = search_plan(changed, options).status;
    if (status == PlanStatus::kPlanned) return true;
    if (status == PlanStatus::kLimit && (is_stopped() || Clock::now() >= deadline)) {
      return std::nullopt;
    }
  } catch (const io::SpecError&) {
    // Such a robot cannot be planned with at all: it cannot stand, say.
  }
  return false;
}

ChangeTried Attempts::smallest(const Direction& direction, Clock::time_point deadline) const {
  const Variable& variable = direction.variable;
  ChangeTried change{variable.name, variable.present, variable.present, variable.unit, false,
                     false};
  std::size_t first = 0;
  std::size_t end = kShares.size();
  while (first < end) {
    const std::size_t rung = (first + end) / 2;
    const std::optional<bool> answer = has_plan(direction, direction.value(rung), deadline);
    change.is_cut_off = !answer;
    if (!answer) break;
    if (*answer || !change.has_plan) change.to = direction.value(rung);
    change.has_plan = change.has_plan || *answer;
    (*answer ? end : first) = *answer ? rung : rung + 1;
  }
  return change;
}

}  // namespace

bool can_be_explained(PlanStatus status) {
  return status == PlanStatus::kLocallyInfeasible || status == PlanStatus::kCheckFails;
}

std::vector<ChangeTried> changes_that_help(const Robot& robot, const PlanOptions& options,
                                           double most_seconds) {
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(std::max(0.0, most_seconds)));
  const Attempts attempts(robot, options);
  std::vector<ChangeTried> changes;
  const std::vector<Direction> directions = directions_of(robot, options);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Clock::time_point now = Clock::now();
    const auto share = (end - now) / static_cast<Clock::rep>(directions.size() - i);
    changes.push_back(attempts.smallest(directions[i], now + share));
  }
  return changes;
}

}  // namespace torquewright::hopper
