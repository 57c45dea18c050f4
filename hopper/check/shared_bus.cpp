// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/shared_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/check/demand.hpp"
#include "actuator/check/geared_torque.hpp"
#include "actuator/region/torque_at.hpp"
#include "io/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

std::vector<const actuator::Actuator*> drives_of(const Robot& robot) {
  std::vector<const actuator::Actuator*> drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) drives.push_back(&actuator);
  }
  return drives;
}

std::vector<SharedBus> groups_of(const std::vector<const actuator::Actuator*>& drives) {
  std::vector<SharedBus> buses;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    if (!drives[i]->battery) continue;
    const auto same = std::find_if(buses.begin(), buses.end(), [&](const SharedBus& bus) {
      return *drives[bus.drives.front()]->battery == *drives[i]->battery;
    });
    (same != buses.end() ? *same : buses.emplace_back()).drives.push_back(i);
  }
  std::erase_if(buses, [](const SharedBus& bus) { return bus.drives.size() < 2; });
  return buses;
}

/// Adds what one drive asks for; torque that no current yields counts as nothing (the drive's own
/// check says so).
void add_power(const CheckedMotion& checked, const actuator::Actuator& actuator, std::size_t drive,
               const Eigen::MatrixXd& torques_Nm, Eigen::VectorXd& power_W) {
  const actuator::PhaseModel model = actuator::phase_model_at(actuator, checked.options.conditions);
  const double temperature_K = winding_temperature_K(actuator, checked.options.conditions);
  const actuator::RotorBeforeMesh rotor(actuator);
  const double rotor_kg_m2 = actuator::before_gears_kg_m2(actuator);
  for (Index sample = 0; sample < power_W.size(); ++sample) {
    const DriveInstant& at = checked.demand.drives[drive][static_cast<std::size_t>(sample)];
    const double torque_Nm = torques_Nm(static_cast<Index>(drive), sample);
    const auto asked = actuator::demand_at(
        actuator, model, temperature_K, at.speed_rad_s,
        rotor.of(at.speed_rad_s, torque_Nm, at.rotor_acceleration_rad_s2(rotor_kg_m2)).motor_Nm);
    if (asked) power_W[sample] += asked->bus_power_W;
  }
}

void settle(const CheckedMotion& checked, const actuator::Supply& supply,
            const Eigen::VectorXd& power_W, SharedBus& bus) {
  bus.open_circuit_V = supply.open_circuit_V;
  bus.power_limit_W = supply.greatest_power_W;
  bus.least_V = bus.open_circuit_V;
  bus.voltage_V.resize(power_W.size());
  for (Index sample = 0; sample < power_W.size(); ++sample) {
    const auto voltage_V = actuator::bus_voltage_V(supply, power_W[sample]);
    const bool delivers = voltage_V && power_W[sample] <= supply.greatest_power_W;
    if (!delivers) ++bus.starved;
    // Where it gives out: at half the open circuit it delivers the most.
    bus.voltage_V[sample] = voltage_V.value_or(0.5 * supply.open_circuit_V);
    if (bus.voltage_V[sample] < bus.least_V) {
      bus.least_V = bus.voltage_V[sample];
      bus.least_time_s = checked.motion.time_s(sample);
    }
    if (power_W[sample] > bus.greatest_power_W) {
      bus.greatest_power_W = power_W[sample];
      bus.power_time_s = checked.motion.time_s(sample);
    }
  }
}

std::string names_of(const CheckedMotion& checked, const SharedBus& bus) {
  std::vector<std::string> all;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    all.insert(all.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  std::vector<std::string> names;
  for (const std::size_t drive : bus.drives) names.push_back(all[drive]);
  return io::listed(names);
}

}  // namespace

std::vector<SharedBus> shared_buses(const CheckedMotion& checked,
                                    const Eigen::MatrixXd& torques_Nm) {
  const auto drives = drives_of(checked.robot);
  std::vector<SharedBus> buses = groups_of(drives);
  for (SharedBus& bus : buses) {
    Eigen::VectorXd power_W = Eigen::VectorXd::Zero(checked.motion.samples());
    for (const std::size_t drive : bus.drives) {
      add_power(checked, *drives[drive], drive, torques_Nm, power_W);
    }
    const actuator::PhaseModel model =
        actuator::phase_model_at(*drives[bus.drives.front()], checked.options.conditions);
    settle(checked, model.supply, power_W, bus);
  }
  return buses;
}

std::vector<Finding> shared_bus_findings(const CheckedMotion& checked,
                                         const std::vector<SharedBus>& buses) {
  std::vector<Finding> findings;
  for (const SharedBus& bus : buses) {
    Finding& finding = findings.emplace_back();
    finding.rule = "shared-battery";
    finding.value = bus.least_V;
    finding.time_s = bus.least_time_s;
    finding.unit = "V";
    finding.sentence = fmt::format(
        "{} load one battery together: its voltage falls from {:.4g} V to {:.4g} V at t = {:.6g} "
        "s, the power is {:.4g} W at most (t = {:.6g} s); every drive is held against the region "
        "at the voltage of each instant",
        names_of(checked, bus), bus.open_circuit_V, bus.least_V, bus.least_time_s,
        bus.greatest_power_W, bus.power_time_s);
    if (bus.starved == 0) continue;
    finding.severity = actuator::Severity::kViolation;
    finding.rule = "battery-power";
    finding.value = bus.greatest_power_W;
    finding.limit = bus.power_limit_W;
    if (!std::isfinite(bus.power_limit_W)) finding.limit.reset();
    finding.time_s = bus.power_time_s;
    finding.unit = "W";
    finding.sentence = fmt::format(
        "{} load one battery together: it cannot deliver the power of {} samples, {:.6g} W at "
        "t = {:.6g} s",
        names_of(checked, bus), bus.starved, bus.greatest_power_W, bus.power_time_s);
  }
  return findings;
}

}  // namespace torquewright::hopper
