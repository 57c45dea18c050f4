// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/mor_plot.hpp"

#include <fmt/format.h>

#include "io/faults/refusal.hpp"
#include "src/report/actuator/region_plot.hpp"

namespace torquewright::cli {

using actuator::OperatingConditions;

std::vector<Overlay> overlays_of(const MorPlotOptions& options, const actuator::Actuator& actuator,
                                 const OperatingConditions& conditions) {
  const double voltage_V = actuator::open_circuit_voltage_V(actuator, conditions);
  const double temperature_K = actuator::winding_temperature_K(actuator, conditions);
  const bool is_peak = conditions.rating == actuator::Rating::kPeak;
  std::vector<Overlay> all{{fmt::format("{}, {:.4g} V, {:.4g} K", is_peak ? "peak" : "continuous",
                                        voltage_V, temperature_K),
                            conditions}};
  OperatingConditions continuous = conditions;
  continuous.rating = actuator::Rating::kContinuous;
  if (is_peak && actuator::objections(actuator, continuous).empty()) {
    all.push_back({"continuous", continuous});
  }
  for (const double other_V : options.voltages_V) {
    OperatingConditions changed = conditions;
    changed.bus_voltage_V = other_V;
    changed.state_of_charge.reset();
    all.push_back({fmt::format("{:.4g} V", other_V), changed});
  }
  for (const double other_K : options.temperatures_K) {
    OperatingConditions changed = conditions;
    changed.winding_temperature_K = other_K;
    all.push_back({fmt::format("{:.4g} K", other_K), changed});
  }
  for (const Overlay& overlay : all) {
    const std::vector<std::string> objections = actuator::objections(actuator, overlay.conditions);
    if (!objections.empty()) io::refuse("--plot", objections.front());
  }
  return all;
}

namespace {

report::PlottedNeed plotted(const AnsweredNeed& needed) {
  const auto& [need, answer] = needed;
  const double greatest_Nm = answer.range.greatest.torque_Nm;
  const double least_Nm = answer.range.least.torque_Nm;
  const bool is_nearer_above = greatest_Nm - need.torque_Nm <= need.torque_Nm - least_Nm;
  return {need.speed_rad_s, need.torque_Nm, answer.margin_Nm,
          is_nearer_above ? greatest_Nm : least_Nm};
}

}  // namespace

std::string region_plot_of(report::PlotFormat format, const actuator::Actuator& actuator,
                           const std::vector<Overlay>& overlays, actuator::Side side,
                           const std::optional<AnsweredNeed>& needed) {
  std::vector<report::PlottedRegion> regions;
  for (const Overlay& overlay : overlays) {
    regions.push_back({overlay.label,
                       actuator::mor_table(actuator::Region(actuator, overlay.conditions, side)),
                       actuator.battery.has_value()});
  }
  const char* place = side == actuator::Side::kMotor ? "motor" : "joint";
  const std::string title =
      fmt::format("{}: motor operating region at the {}", actuator.name, place);
  std::optional<report::PlottedNeed> point;
  if (needed) point = plotted(*needed);
  return report::region_plot(format, title, regions, point);
}

}  // namespace torquewright::cli
