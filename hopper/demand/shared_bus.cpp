// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/shared_bus.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "actuator/drive_check/demand.hpp"
#include "actuator/drive_check/geared_torque.hpp"
#include "actuator/drive_check/interpretation_check.hpp"
#include "actuator/region/torque_at.hpp"
#include "io/text/time_text.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kRounding = 1e-9;       // of the greatest power
constexpr double kLinesSettled = 1e-12;  // of the open circuit, where lines' losses are solved for
constexpr int kMostLineVoltages = 100;

std::vector<const actuator::Actuator*> drives_of(const Robot& robot) {
  std::vector<const actuator::Actuator*> drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) drives.push_back(&actuator);
  }
  return drives;
}

/// What one drive asks for; torque that no current yields counts as nothing (the drive's own check
/// says so).
Eigen::VectorXd power_of_W(const CheckedMotion& checked, const actuator::Actuator& actuator,
                           std::size_t drive, const Eigen::MatrixXd& torques_Nm) {
  Eigen::VectorXd power_W = Eigen::VectorXd::Zero(checked.motion.samples());
  const actuator::PhaseModel model = actuator::phase_model_at(actuator, checked.options.conditions);
  const double temperature_K = winding_temperature_K(actuator, checked.options.conditions);
  const actuator::RotorBeforeMesh rotor(actuator);
  const double rotor_kg_m2 = actuator::before_gears_kg_m2(actuator);
  const double rest_rad_s = actuator::rest_speed_rad_s(actuator, model);
  double before_rad_s = 0.0;
  for (Index sample = 0; sample < power_W.size(); ++sample) {
    const DriveInstant& at = checked.demand.drives[drive][static_cast<std::size_t>(sample)];
    const double torque_Nm = torques_Nm(static_cast<Index>(drive), sample);
    const double speed_rad_s = std::abs(at.speed_rad_s) < rest_rad_s ? 0.0 : at.speed_rad_s;
    const auto asked = actuator::demand_at(
        actuator, model, temperature_K, speed_rad_s,
        rotor.of(speed_rad_s, torque_Nm, at.rotor_acceleration_rad_s2(rotor_kg_m2), before_rad_s)
            .motor_Nm);
    before_rad_s = speed_rad_s;
    if (asked) power_W[sample] = asked->bus_power_W;
  }
  return power_W;
}

/// All drives', with what their lines lose at the voltage that the battery is left.
Eigen::VectorXd drawn_W(const DriveSupply& feeds, const std::vector<Eigen::VectorXd>& powers_W) {
  Eigen::VectorXd drawn_W = powers_W.front();
  for (std::size_t i = 1; i < powers_W.size(); ++i) drawn_W += powers_W[i];
  const auto has_line = [](double line_ohm) { return line_ohm > 0.0; };
  if (std::none_of(feeds.lines_ohm.begin(), feeds.lines_ohm.end(), has_line)) return drawn_W;
  for (Index sample = 0; sample < drawn_W.size(); ++sample) {
    double voltage_V = feeds.supply.open_circuit_V;
    for (int tried = 0; tried < kMostLineVoltages; ++tried) {
      const double before_V = voltage_V;
      voltage_V = loaded_voltage_V(feeds.supply, drawn_W[sample]);
      drawn_W[sample] = 0.0;
      for (std::size_t i = 0; i < powers_W.size(); ++i) {
        drawn_W[sample] += drawn_power_W(voltage_V, feeds.lines_ohm[i], powers_W[i][sample]);
      }
      if (std::abs(voltage_V - before_V) <= kLinesSettled * feeds.supply.open_circuit_V) break;
    }
  }
  return drawn_W;
}

void settle(const CheckedMotion& checked, const actuator::Supply& supply,
            const Eigen::VectorXd& power_W, SharedBus& bus) {
  bus.open_circuit_V = supply.open_circuit_V;
  bus.power_limit_W = supply.greatest_power_W;
  bus.return_limit_W = supply.least_power_W;
  bus.voltage_V.resize(power_W.size());
  const double rounding_W = kRounding * power_W.cwiseAbs().maxCoeff();
  for (Index sample = 0; sample < power_W.size(); ++sample) {
    bus.voltage_V[sample] = loaded_voltage_V(supply, power_W[sample]);
    if (power_W[sample] > greatest_power_W(supply) + rounding_W) ++bus.starved;
    if (power_W[sample] < bus.return_limit_W - rounding_W) ++bus.flooded;
  }
  const auto time_s = [&](Index sample) { return checked.motion.time_s(sample); };
  Index sample = 0;
  bus.least_V = std::min(bus.open_circuit_V, bus.voltage_V.minCoeff(&sample));
  bus.least_time_s = time_s(sample);
  bus.greatest_power_W = std::max(0.0, power_W.maxCoeff(&sample));
  bus.power_time_s = time_s(sample);
  bus.least_power_W = std::min(0.0, power_W.minCoeff(&sample));
  bus.return_time_s = time_s(sample);
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

std::vector<BatteryPower> battery_powers(const CheckedMotion& checked,
                                         const Eigen::MatrixXd& torques_Nm) {
  const auto drives = drives_of(checked.robot);
  std::vector<BatteryPower> batteries;
  for (DriveSupply& feeds : drive_supplies(drives, checked.options.conditions)) {
    std::vector<Eigen::VectorXd> powers_W;
    for (const std::size_t drive : feeds.drives) {
      powers_W.push_back(power_of_W(checked, *drives[drive], drive, torques_Nm));
    }
    const Eigen::VectorXd power_W = drawn_W(feeds, powers_W);
    batteries.push_back({std::move(feeds), power_W});
  }
  return batteries;
}

std::vector<SharedBus> shared_buses(const CheckedMotion& checked,
                                    const Eigen::MatrixXd& torques_Nm) {
  std::vector<SharedBus> buses;
  for (BatteryPower& battery : battery_powers(checked, torques_Nm)) {
    if (battery.feeds.drives.size() < 2) continue;
    SharedBus& bus = buses.emplace_back();
    bus.drives = std::move(battery.feeds.drives);
    settle(checked, battery.feeds.supply, battery.power_W, bus);
  }
  return buses;
}

std::string overload_of(const SharedBus& bus) {
  std::vector<std::string> sentences;
  if (bus.starved > 0) {
    sentences.push_back(
        fmt::format("it cannot deliver the power of {} samples, {:.6g} W at t = {} s", bus.starved,
                    bus.greatest_power_W, io::time_text(bus.power_time_s)));
  }
  if (bus.flooded > 0) {
    sentences.push_back(fmt::format(
        "it cannot take back the power of {} samples, {:.6g} W at t = {} s, where {:.6g} W are "
        "the most by its charge_limit_A or maximum_voltage_V",
        bus.flooded, -bus.least_power_W, io::time_text(bus.return_time_s),
        0.0 - bus.return_limit_W));
  }
  return fmt::format("{}", fmt::join(sentences, "; "));
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
        "{} load one battery together: its voltage falls from {:.4g} V to {:.4g} V at t = {} "
        "s, the power is {:.4g} W at most (t = {} s); every drive is held against the region "
        "at the voltage of each instant",
        names_of(checked, bus), bus.open_circuit_V, bus.least_V, io::time_text(bus.least_time_s),
        bus.greatest_power_W, io::time_text(bus.power_time_s));
    if (bus.starved + bus.flooded == 0) continue;
    const bool is_starved = bus.starved > 0;
    finding.severity = actuator::Severity::kViolation;
    finding.rule = "battery-power";
    finding.value = is_starved ? bus.greatest_power_W : bus.least_power_W;
    finding.limit = (is_starved ? bus.power_limit_W : bus.return_limit_W) + 0.0;  // no -0
    if (!std::isfinite(*finding.limit)) finding.limit.reset();
    finding.time_s = is_starved ? bus.power_time_s : bus.return_time_s;
    finding.unit = "W";
    finding.sentence =
        fmt::format("{} load one battery together: {}", names_of(checked, bus), overload_of(bus));
  }
  return findings;
}

}  // namespace torquewright::hopper
