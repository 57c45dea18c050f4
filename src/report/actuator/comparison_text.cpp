// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/comparison_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::report {
namespace {

using namespace actuator;

/// "-12.3 Nm (10 %) at 8.2 rad/s"; nothing where nothing changes.
std::string change_text(const TorqueChange& change) {
  if (change.change_Nm == 0.0) return "none";
  const std::string share =
      change.from_Nm > 0.0 ? fmt::format(" ({:+.1f} %)", 100.0 * change.change_Nm / change.from_Nm)
                           : std::string();
  return fmt::format("{:+.4g} Nm{} at {:.4g} rad/s", change.change_Nm, share, change.speed_rad_s);
}

std::string figure_row(const char* what, double from, double to, const char* unit) {
  const std::string share =
      from > 0.0 ? fmt::format("{:+.2f} %", 100.0 * (to - from) / from) : std::string();
  return fmt::format("  {:<16} {:>12.5g} {:>12.5g} {:<6} {:>9}\n", what, from, to, unit, share);
}

}  // namespace

std::string comparison_text(const std::string& from, const std::string& to,
                            const RegionComparison& comparison) {
  std::string text =
      fmt::format("from {}\nto   {}\n  {:<16} {:>12} {:>12}\n", from, to, "", "from", "to");
  const RegionFigures &a = comparison.from, &b = comparison.to;
  text += figure_row("peak torque", a.peak_torque_Nm, b.peak_torque_Nm, "Nm");
  text += figure_row("stall torque", a.stall_torque_Nm, b.stall_torque_Nm, "Nm");
  text += figure_row("no-load speed", a.no_load_speed_rad_s, b.no_load_speed_rad_s, "rad/s");
  text += fmt::format("  {:<16}   {:<40} {}\n", "torque", "worst loss", "best gain");
  for (std::size_t q = 0; q < kQuadrants.size(); ++q) {
    const QuadrantComparison& quadrant = comparison.quadrants[q];
    text += fmt::format("  {:<16}   {:<40} {}\n", kQuadrants[q].name,
                        change_text(quadrant.worst_loss), change_text(quadrant.best_gain));
  }
  if (comparison.one_sided_rad_s) {
    text += fmt::format(
        "  at some speeds, such as {:.4g} rad/s, one of the regions is empty: they do not count\n",
        *comparison.one_sided_rad_s);
  }
  return text;
}

}  // namespace torquewright::report
