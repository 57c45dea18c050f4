// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/momentum_plot.hpp"

#include "src/report/parts/plot_panels.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;

PlotPanel panel_of(const char* axis, const char* label, const Eigen::MatrixXd& table, Index row) {
  return {axis, {{label, [&table, row](Index sample) { return table(row, sample); }}}};
}

}  // namespace

std::string momentum_plot(PlotFormat format, const HopperPage& page) {
  const hopper::Demand& demand = page.report.demand;
  if (!demand.has_dynamics) return "";
  constexpr Index kLateral = 1;
  std::vector<PlotMark> marks;
  for (const hopper::Flight& flight : page.report.flights) {
    marks.push_back({flight.from_s, "take-off"});
    marks.push_back({flight.until_s, "touch-down"});
  }
  return panels_plot(format, page.motion,
                     {panel_of("Nm s", "CAM, angular momentum about the centre of mass",
                               demand.angular_momentum_Nm_s, kLateral),
                      panel_of("rad/s", "CAV, the mean angular velocity that goes with it",
                               demand.angular_velocity_rad_s, kLateral),
                      panel_of("kg m^2", "composite inertia", demand.lateral_inertia_kg_m2, 0)},
                     marks);
}

}  // namespace torquewright::report
