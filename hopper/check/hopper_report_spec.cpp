// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/hopper_report_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/drive_check/check_report_spec.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : nullptr; }

ordered_json peak_json(const ResidualPeak& peak, const char* unit) {
  return {{"mean", number(peak.mean)},
          {"limit", number(peak.limit)},
          {"unit", unit},
          {"time_s", number(peak.time_s)}};
}

ordered_json residual_json(const HopperReport& report) {
  if (!report.demand.has_dynamics) return nullptr;
  const BaseResidual& residual = report.base_residual;
  return {{"window_s", residual.window_s},
          {"force", peak_json(residual.force, "N")},
          {"moment", peak_json(residual.moment, "Nm")},
          {"passive_joints", peak_json(residual.passive, "Nm")},
          {"weight_N", report.demand.weight_N},
          {"size_m", report.demand.size_m}};
}

ordered_json limit_json(const TransmissionLoad& load) {
  if (!load.limit) return nullptr;
  return {{"torque_Nm", load.limit->torque_Nm},
          {"side", load.is_judged_at_joint() ? "joint" : "motor"},
          {"source", load.limit->source},
          {"margin_Nm", load.limit->torque_Nm - load.judged().mean},
          {"verdict", actuator::name_of(load.verdict)}};
}

ordered_json load_json(const TransmissionLoad& load) {
  return {{"drive", load.drive},
          {"ratio", load.ratio},
          {"joint_Nm", load.joint.mean},
          {"motor_Nm", load.motor.mean},
          {"time_s", load.judged().time_s},
          {"window_s", load.window_s},
          {"without_impulses_joint_Nm", load.joint.without_impulses},
          {"peak_joint_Nm", load.peak_joint_Nm},
          {"peak_motor_Nm", load.peak_motor_Nm},
          {"peak_time_s", load.peak_time_s},
          {"rotor_impulse_Nm_s", load.rotor_Nm_s},
          {"impulse_time_s", load.impact_time_s},
          {"least_motor_Nm", load.motor.least},
          {"most_motor_Nm", load.motor.most},
          {"sampling_doubt_Nm_s", load.doubt_Nm_s},
          {"sampling_doubt_time_s", load.doubt_time_s},
          {"limit", limit_json(load)}};
}

ordered_json contact_json(const ContactLoad& load) {
  return {{"drive", load.drive},
          {"ratio", load.ratio},
          {"joint_Nm", load.joint_Nm},
          {"motor_Nm", load.motor_Nm},
          {"time_s", load.time_s},
          {"without_impulses_joint_Nm", load.steady_joint_Nm},
          {"impulse_Nm_s", load.impulse_Nm_s},
          {"impulse_time_s", load.impulse_time_s}};
}

ordered_json heat_json(const HopperReport& report) {
  ordered_json heat = ordered_json::array();
  for (const actuator::DriveReport& drive : report.check.drives) {
    if (!drive.interpretation.winding) continue;
    const actuator::WindingReport& winding = *drive.interpretation.winding;
    heat.push_back({{"drive", drive.name},
                    {"first_run_peak_K", number(winding.first_peak_K)},
                    {"limit_K", winding.limit_K},
                    {"runs_to_limit", winding.runs_to_limit ? ordered_json(*winding.runs_to_limit)
                                                            : ordered_json()}});
  }
  return heat;
}

ordered_json flight_json(const Flight& flight) {
  return {{"from_s", flight.from_s},
          {"until_s", flight.until_s},
          {"angular_momentum_Nm_s", flight.angular_momentum_Nm_s},
          {"angular_momentum_drift_Nm_s", flight.angular_momentum_drift_Nm_s},
          {"take_off_rad_s", flight.take_off_rad_s},
          {"peak_rad_s", flight.peak_rad_s},
          {"touch_down_rad_s", flight.touch_down_rad_s},
          {"rise_m", flight.rise_m},
          {"angular_momentum_limit_Nm_s", flight.angular_momentum_limit_Nm_s},
          {"fall_error_m_s2", flight.fall_error_m_s2},
          {"fall_limit_m_s2", flight.fall_limit_m_s2}};
}

/// Infinity: at any speed.
ordered_json contact_rule_json(const HopperReport& report) {
  const ContactSchedule& contacts = report.contacts;
  if (contacts.origin != Origin::kDerived || !report.demand.has_dynamics) return nullptr;
  return {{"height_m", contacts.thresholds.height_m},
          {"speed_m_s", number(contacts.thresholds.speed_m_s)},
          {"searched", contacts.is_searched},
          {"unexplained_share", number(contacts.unexplained_share)}};
}

ordered_json doubt_json(const PeakDoubt& doubt) {
  return {{"drive", doubt.drive},
          {"peak_Nm", number(doubt.peak_Nm)},
          {"time_s", doubt.time_s},
          {"least_Nm", number(doubt.least_Nm)},
          {"most_Nm", number(doubt.most_Nm)}};
}

ordered_json bus_json(const HopperReport& report, const SharedBus& bus) {
  ordered_json drives = ordered_json::array();
  for (const std::size_t drive : bus.drives) drives.push_back(report.check.drives[drive].name);
  return {{"drives", drives},
          {"open_circuit_V", bus.open_circuit_V},
          {"least_V", bus.least_V},
          {"least_time_s", bus.least_time_s},
          {"greatest_power_W", bus.greatest_power_W},
          {"starved_samples", bus.starved}};
}

template <typename List, typename Make>
ordered_json list_of(const List& list, const Make& make) {
  ordered_json entries = ordered_json::array();
  for (const auto& entry : list) entries.push_back(make(entry));
  return entries;
}

}  // namespace

ordered_json transmission_load_json(const std::vector<TransmissionLoad>& loads) {
  return list_of(loads, load_json);
}

ordered_json contact_load_json(const std::vector<ContactLoad>& loads) {
  return list_of(loads, contact_json);
}

ordered_json hopper_report_json(const HopperReport& report) {
  ordered_json document = actuator::check_report_json(report.check);
  document["transmission_load"] = transmission_load_json(report.transmission_loads);
  document["contact_load"] = contact_load_json(report.contact_loads);
  document["base_residual"] = residual_json(report);
  document["contact_rule"] = contact_rule_json(report);
  document["torque_doubt"] = list_of(report.peak_doubts, doubt_json);
  document["heat"] = heat_json(report);
  document["flights"] = list_of(report.flights, flight_json);
  document["buses"] =
      list_of(report.buses, [&](const SharedBus& bus) { return bus_json(report, bus); });
  return document;
}

}  // namespace torquewright::hopper
