// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/battery_charge.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actuator/drive_check/integral.hpp"
#include "hopper/demand/shared_bus.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kSecondsPerHour = 3600.0;

/// A battery that some motion drains.
struct Drain {
  std::vector<std::string> drives;  ///< Names.
  double run_Ah = 0.0;              ///< What one run takes, less what it returns.
  double left_Ah = 0.0;             ///< What is in it before the first run.
  bool taken_for_full = false;      ///< Nobody stated how full it is.
};

double charge_Ah(const CheckedMotion& checked, const BatteryPower& battery) {
  actuator::Integral charge_C;
  for (Eigen::Index sample = 0; sample < battery.power_W.size(); ++sample) {
    const double power_W = battery.power_W[sample];
    charge_C.add(checked.motion.time_s(sample),
                 power_W / loaded_voltage_V(battery.feeds.supply, power_W));
  }
  return charge_C.sum() / kSecondsPerHour;
}

Finding finding_of(const Drain& drain, std::size_t runs) {
  const double lasts = std::floor(drain.left_Ah / drain.run_Ah);
  Finding finding;
  finding.rule = "battery-charge";
  finding.value = drain.run_Ah * static_cast<double>(runs);
  finding.limit = drain.left_Ah;
  finding.unit = "Ah";
  finding.sentence = fmt::format(
      "a run of the motion takes {:.4g} Ah, {:.3g} % of what is in the battery of {} ({:.4g} Ah{})",
      drain.run_Ah, 100.0 * drain.run_Ah / drain.left_Ah, io::listed(drain.drives), drain.left_Ah,
      drain.taken_for_full ? ", taken for full" : "");
  if (*finding.value > drain.left_Ah) {
    finding.severity = actuator::Severity::kViolation;
    finding.sentence += fmt::format(": it lasts for {:g} of {} runs", lasts, runs);
  } else {
    finding.sentence += fmt::format(": it lasts for {:g} runs", lasts);
  }
  return finding;
}

}  // namespace

std::vector<Finding> battery_charge_findings(const Robot& robot,
                                             const actuator::OperatingConditions& conditions,
                                             const std::vector<double>& drawn_Ah,
                                             std::size_t runs) {
  std::vector<std::string> names;
  std::vector<const actuator::Actuator*> drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      names.push_back(drivetrain.actuator_names[i]);
      drives.push_back(&drivetrain.actuators[i]);
    }
  }
  std::vector<Finding> findings;
  const std::vector<DriveSupply> supplies = drive_supplies(drives, conditions);
  for (std::size_t i = 0; i < supplies.size() && i < drawn_Ah.size(); ++i) {
    const auto& pack = drives[supplies[i].drives.front()]->battery;
    if (!pack || !pack->cell_capacity_Ah || !(drawn_Ah[i] > 0.0)) continue;
    Drain drain;
    for (const std::size_t drive : supplies[i].drives) drain.drives.push_back(names[drive]);
    drain.run_Ah = drawn_Ah[i];
    drain.taken_for_full = !conditions.state_of_charge;
    drain.left_Ah =
        conditions.state_of_charge.value_or(1.0) * *pack->cell_capacity_Ah * pack->parallel_cells;
    findings.push_back(finding_of(drain, runs));
  }
  return findings;
}

std::vector<Finding> battery_charge_findings(const CheckedMotion& checked,
                                             const Eigen::MatrixXd& torques_Nm) {
  std::vector<double> drawn_Ah;
  for (const BatteryPower& battery : battery_powers(checked, torques_Nm)) {
    drawn_Ah.push_back(charge_Ah(checked, battery));
  }
  return battery_charge_findings(checked.robot, checked.options.conditions, drawn_Ah,
                                 checked.options.runs);
}

}  // namespace torquewright::hopper
