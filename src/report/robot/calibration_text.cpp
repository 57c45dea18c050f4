// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/calibration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

namespace calibration = hopper::calibration;

constexpr std::size_t kEveryPoint = 3;  // of a profile in the text; --json has all of them

std::string ranges_text(const calibration::Profile& profile) {
  std::string text;
  for (const calibration::Profile::Range& range : profile.ranges) {
    if (!text.empty()) text += " and ";
    text += fmt::format("{:.4g} to {:.4g}", range.low, range.high);
  }
  return text;
}

std::string targets_text(const CalibrationReport& report) {
  const calibration::Figures& figures = report.question.figures;
  std::string text = fmt::format("  {:<12} {:>11} {:>9} {:>8} {:>16} {:>9}\n", "posture",
                                 "CAV rad/s", "reached", "error", "inertia kg m2", "reached");
  const auto inertias = calibration::inertias_kg_m2(report.question, report.found.best->values);
  for (std::size_t i = 0; i < inertias.size(); ++i) {
    const calibration::SpeedTarget& target = figures.speeds[i];
    const double reached = figures.angular_momentum_Nm_s / inertias[i];
    text += fmt::format("  {:<12} {:>11.4g} {:>9.4g} {:>+7.2f}% {:>16.4g} {:>9.4g}\n",
                        report.question.postures[target.posture].name, target.speed_rad_s, reached,
                        100.0 * (reached / target.speed_rad_s - 1.0),
                        figures.angular_momentum_Nm_s / target.speed_rad_s, inertias[i]);
  }
  return text;
}

std::size_t longest_name(const CalibrationReport& report) {
  std::size_t longest = 10;
  for (const calibration::FreeValue& free : report.question.free) {
    longest = std::max(longest, free.name().size());
  }
  return longest;
}

std::string values_text(const CalibrationReport& report) {
  const std::size_t width = longest_name(report);
  std::string text = fmt::format("  {:<{}} {:>10} {:>10} {:>22}  {}\n", "free value", width,
                                 "document", "fitted", "bounds", "met, the others fitted anew");
  for (std::size_t i = 0; i < report.question.free.size(); ++i) {
    const calibration::FreeValue& free = report.question.free[i];
    text += fmt::format(
        "  {:<{}} {:>10.4g} {:>10.4g} {:>22}  {}\n", free.name(), width, free.documented,
        report.found.best->values[i],
        fmt::format("{:.4g} to {:.4g}{}", free.lowest, free.highest,
                    free.has_stated_bounds ? "" : " *"),
        report.found.profiles.empty() ? "nowhere" : ranges_text(report.found.profiles[i]));
  }
  const bool has_own_bounds =
      std::any_of(report.question.free.begin(), report.question.free.end(),
                  [](const calibration::FreeValue& free) { return !free.has_stated_bounds; });
  return has_own_bounds ? text + "  * not stated: plausible ones\n" : text;
}

std::string point_row(const calibration::ProfilePoint& point, const calibration::Figures& figures) {
  if (!point.best) return fmt::format("  {:>10.4g}   no body has such inertias\n", point.value);
  std::string text =
      fmt::format("  {:>10.4g} {:>8.2f}% {:>4}  ", point.value, 100.0 * point.best->worst_error,
                  calibration::meets(figures, point.best) ? "met" : "-");
  // A fit ends next to a bound of zero, at 1e-8 or so.
  for (const double value : point.best->values) {
    text += fmt::format(" {:>10.4g}", std::abs(value) < 1e-6 ? 0.0 : value);
  }
  return text + "\n";
}

std::string profile_text(const CalibrationReport& report, std::size_t index) {
  const calibration::Profile& profile = report.found.profiles[index];
  std::string text = fmt::format("\nAlong {}: worst error, and all free values in their order\n",
                                 report.question.free[index].name());
  for (std::size_t i = 0; i < profile.points.size(); i += kEveryPoint) {
    text += point_row(profile.points[i], report.question.figures);
  }
  return text;
}

}  // namespace

std::string calibration_verdict(const CalibrationReport& report) {
  const calibration::Calibration& found = report.found;
  if (!found.best) return "not met: no values within the bounds are inertias that bodies have.";
  const double allowed = 100.0 * report.question.figures.tolerance;
  if (!found.is_met) {
    return fmt::format("not met: the best is off by {:.2f} %, more than {:.3g} %.",
                       100.0 * found.best->worst_error, allowed);
  }
  if (found.is_determined()) {
    return fmt::format("met within {:.3g} %, and the figures determine every free value.", allowed);
  }
  std::string open;
  for (std::size_t i = 0; i < found.profiles.size(); ++i) {
    if (found.profiles[i].is_determined) continue;
    open += fmt::format("{}{} ({})", open.empty() ? "" : ", ", report.question.free[i].name(),
                        ranges_text(found.profiles[i]));
  }
  return fmt::format(
      "met within {:.3g} %, but by a valley of solutions: the figures leave open {}.", allowed,
      open);
}

std::string calibration_provenance(const CalibrationReport& report, std::size_t index,
                                   const std::string& pointer) {
  const calibration::Figures& figures = report.question.figures;
  std::string text =
      fmt::format("{} = {:.6g}: fitted by hopper calibrate to CAM {:.6g} N m s", pointer,
                  report.found.best->values[index], figures.angular_momentum_Nm_s);
  for (const calibration::SpeedTarget& target : figures.speeds) {
    text += fmt::format(", CAV {:.6g} rad/s at {}", target.speed_rad_s,
                        report.question.postures[target.posture].name);
  }
  if (!report.found.is_met) {
    return text + fmt::format("; not met, off by {:.3g} %", 100.0 * report.found.best->worst_error);
  }
  const calibration::Profile& profile = report.found.profiles[index];
  if (profile.is_determined) return text;
  return text + "; one of a valley: " + ranges_text(profile) + " would do as well";
}

std::string calibration_text(const CalibrationReport& report) {
  std::string text = fmt::format("{}: {}\n", report.robot, calibration_verdict(report));
  text += fmt::format(
      "CAM, the angular momentum about the centre of mass, is {:.4g} N m s about the pitch axis\n"
      "and conserved in flight; CAV = CAM/inertia of the posture,\n"
      "whatever the joints' speeds (with joints at rest it is the robot's own angular "
      "velocity).\n\n",
      report.question.figures.angular_momentum_Nm_s);
  if (!report.found.best) return text;
  text += targets_text(report) + "\n" + values_text(report);
  for (std::size_t i = 0; i < report.found.profiles.size(); ++i) text += profile_text(report, i);
  return text;
}

}  // namespace torquewright::report
