// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/calibration_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

namespace calibration = hopper::calibration;
using nlohmann::ordered_json;

ordered_json targets_json(const CalibrationReport& report) {
  const calibration::Figures& figures = report.question.figures;
  ordered_json targets = ordered_json::array();
  std::vector<double> inertias;
  if (report.found.best)
    inertias = calibration::inertias_kg_m2(report.question, report.found.best->values);
  for (std::size_t i = 0; i < figures.speeds.size(); ++i) {
    const calibration::SpeedTarget& target = figures.speeds[i];
    targets.push_back({{"posture", report.question.postures[target.posture].name},
                       {"angular_velocity_rad_s", target.speed_rad_s},
                       {"inertia_kg_m2", figures.angular_momentum_Nm_s / target.speed_rad_s}});
    if (inertias.empty()) continue;
    targets.back()["reached_rad_s"] = figures.angular_momentum_Nm_s / inertias[i];
    targets.back()["reached_inertia_kg_m2"] = inertias[i];
  }
  return targets;
}

ordered_json profile_json(const calibration::Profile& profile,
                          const calibration::Figures& figures) {
  ordered_json result;
  result["is_determined"] = profile.is_determined;
  result["ranges"] = ordered_json::array();
  for (const calibration::Profile::Range& range : profile.ranges) {
    result["ranges"].push_back(ordered_json::array({range.low, range.high}));
  }
  result["points"] = ordered_json::array();
  for (const calibration::ProfilePoint& point : profile.points) {
    ordered_json entry{{"value", point.value}, {"is_met", calibration::meets(figures, point.best)}};
    if (point.best) {
      entry["worst_error"] = point.best->worst_error;
      entry["values"] = point.best->values;
    }
    result["points"].push_back(entry);
  }
  return result;
}

ordered_json free_json(const CalibrationReport& report, std::size_t index) {
  const calibration::FreeValue& free = report.question.free[index];
  ordered_json entry;
  entry["pointers"] = free.pointers;
  entry["documented"] = free.documented;
  entry["lowest"] = free.lowest;
  entry["highest"] = free.highest;
  if (report.found.best) entry["fitted"] = report.found.best->values[index];
  if (!report.found.profiles.empty()) {
    entry["profile"] = profile_json(report.found.profiles[index], report.question.figures);
  }
  return entry;
}

}  // namespace

ordered_json calibration_json(const CalibrationReport& report) {
  ordered_json document;
  document["kind"] = "calibration_report";
  document["version"] = 1;
  document["robot"] = report.robot;
  document["verdict"] = !report.found.is_met           ? "not_met"
                        : report.found.is_determined() ? "determined"
                                                       : "valley";
  document["sentence"] = calibration_verdict(report);
  document["angular_momentum_Nm_s"] = report.question.figures.angular_momentum_Nm_s;
  document["tolerance"] = report.question.figures.tolerance;
  if (report.found.best) document["worst_error"] = report.found.best->worst_error;
  document["targets"] = targets_json(report);
  document["free"] = ordered_json::array();
  for (std::size_t i = 0; i < report.question.free.size(); ++i) {
    document["free"].push_back(free_json(report, i));
  }
  return document;
}

}  // namespace torquewright::report
