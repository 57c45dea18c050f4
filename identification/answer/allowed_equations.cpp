// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/allowed_equations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "identification/signals/bench.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

/// An equation, and what must be added for it; nothing is missing where it is allowed.
struct Need {
  std::string equation;
  std::vector<std::string> missing;
};

bool has_any(const Channels& channels, std::initializer_list<Quantity> list) {
  return std::any_of(list.begin(), list.end(), [&](Quantity one) { return channels.has(one); });
}

bool shows_motion(const Channels& channels) {
  return has_any(channels,
                 {Quantity::kOutputPosition, Quantity::kMotorPosition, Quantity::kLinearPosition,
                  Quantity::kOutputVelocity, Quantity::kMotorVelocity, Quantity::kLinearVelocity});
}

Need torque_balance(const Bench& bench) {
  Need need{"torque balance", {}};
  if (!bench.drive) {
    need.missing.emplace_back(
        "nothing says what the motor does; add motor_current_A, reported_torque_Nm, "
        "commanded_torque_Nm, winding_voltage_V or duty");
  }
  if (!bench.load_side) {
    need.missing.emplace_back(
        "neither output_torque_Nm nor linear_force_N nor a load with inertia; add one of these "
        "columns, or state the \"load\" that is moved");
  }
  return need;
}

/// Those that compare measured channels with each other.
std::vector<Need> plain_needs(const Channels& channels) {
  std::vector<Need> needs;
  const auto ask = [&](const char* equation, auto... lists) {
    Need need{equation, {}};
    const auto require = [&](const std::pair<const char*, bool>& one) {
      if (!one.second) need.missing.emplace_back(one.first);
    };
    (require(lists), ...);
    needs.push_back(std::move(need));
  };
  const std::pair current{"motor_current_A", channels.has(Quantity::kMotorCurrent)};
  const std::pair position{"output_position_rad", has_any(channels, {Quantity::kOutputPosition,
                                                                     Quantity::kLinearPosition})};
  ask("winding voltage", current,
      std::pair{"winding_voltage_V or duty",
                has_any(channels, {Quantity::kWindingVoltage, Quantity::kDuty})});
  ask("bus voltage", current, std::pair{"bus_voltage_V", channels.has(Quantity::kBusVoltage)});
  ask("twist", position, std::pair{"motor_position_rad", channels.has(Quantity::kMotorPosition)});
  ask("velocity",
      std::pair{"output_velocity_rad_s",
                has_any(channels, {Quantity::kOutputVelocity, Quantity::kLinearVelocity})});
  return needs;
}

std::string sentence(const Need& need) {
  const bool is_balance = need.equation == "torque balance";
  return fmt::format("no {}: {}{}", need.equation, is_balance ? "" : "add ",
                     fmt::join(need.missing, is_balance ? "; and " : " and "));
}

std::string of_joint(const std::string& joint) {
  return joint.empty() ? "" : fmt::format(" of the joint \"{}\"", joint);
}

}  // namespace

void check_equations(Log& log, const Rig& rig) {
  std::vector<io::Fault> faults;
  bool is_any_allowed = false;
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    const Channels& channels = log.runs.front().joints[joint];
    const std::string whose = of_joint(rig.joints[joint]);
    if (!shows_motion(channels)) {
      throw io::SpecError({{rig.file, "/columns",
                            fmt::format("no column is a position or velocity{}; every equation "
                                        "needs the motion",
                                        whose)}});
    }
    const Need balance = torque_balance(make_bench(rig, log, joint, {}));
    std::vector<Need> needs = plain_needs(channels);
    needs.insert(needs.begin(), balance);
    for (const Need& need : needs) {
      is_any_allowed = is_any_allowed || need.missing.empty();
      if (need.missing.empty()) continue;
      faults.push_back({rig.file, "/columns", sentence(need) + whose});
    }
    if (balance.missing.empty()) continue;
    log.findings.push_back({Weight::kWarning, sentence(balance) + whose});
  }
  if (!is_any_allowed) throw io::SpecError(std::move(faults));
}

}  // namespace torquewright::identification
