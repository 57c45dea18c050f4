// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/result/least_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// Margin over what it is measured by: the limit, or the range between two.
struct Judged {
  LeastMargin margin;
  double share = 0.0;
};

/// Keeps of each rule the least.
class Least {
 public:
  void add(LeastMargin margin, double size) {
    const double share = size > 0.0 ? margin.margin / size : margin.margin;
    const auto same = std::find_if(judged_.begin(), judged_.end(), [&](const Judged& one) {
      return one.margin.rule == margin.rule;
    });
    if (same == judged_.end()) {
      judged_.push_back({std::move(margin), share});
    } else if (share < same->share) {
      *same = {std::move(margin), share};
    }
  }
  std::vector<LeastMargin> sorted() {
    std::stable_sort(judged_.begin(), judged_.end(),
                     [](const Judged& a, const Judged& b) { return a.share < b.share; });
    std::vector<LeastMargin> out;
    for (Judged& one : judged_) out.push_back(std::move(one.margin));
    return out;
  }

 private:
  std::vector<Judged> judged_;
};

void add_regions(const HopperReport& report, Least& least) {
  for (const actuator::DriveReport& drive : report.check.drives) {
    const actuator::WorstSample& worst = drive.interpretation.worst;
    if (!worst.limit_Nm) continue;
    least.add({"motor-operating-region", drive.name, worst.time_s, worst.torque_Nm, *worst.limit_Nm,
               drive.interpretation.margin_Nm, "Nm"},
              std::abs(*worst.limit_Nm));
  }
}

void add_transmissions(const HopperReport& report, Least& least) {
  for (const TransmissionLoad& load : report.transmission_loads) {
    if (!load.limit) continue;
    const WindowLoad& judged = load.judged();
    least.add({"transmission-load", load.drive, judged.time_s, judged.mean, load.limit->torque_Nm,
               load.limit->torque_Nm - judged.mean, "Nm"},
              load.limit->torque_Nm);
  }
}

/// Friction, centre of pressure and mechanisms say how far they are in findings.
void add_findings(const HopperReport& report, Least& least) {
  for (const actuator::Finding& finding : report.check.findings) {
    if (!finding.time_s || !finding.value || !finding.limit) continue;
    const double above = *finding.value - *finding.limit;
    LeastMargin margin{finding.rule,   finding.joint, *finding.time_s, *finding.value,
                       *finding.limit, above,         finding.unit};
    if (finding.rule == "friction-cone") {
      margin.margin = -above;
      least.add(std::move(margin), *finding.limit);
    } else if (finding.rule == "centre-of-pressure") {
      least.add(std::move(margin), 1.0);
    } else if (finding.rule == "mechanism-margin") {
      // Some of its limits are upper ones; what is broken is a violation.
      const bool is_broken = finding.severity == actuator::Severity::kViolation;
      margin.margin = is_broken ? -std::abs(above) : std::abs(above);
      least.add(std::move(margin), 1.0);
    }
  }
}

/// Farthest towards a limit, of a row of a table.
void add_joints(const Robot& robot, const Motion& motion, Least& least) {
  const Index base_positions =
      robot.tree.position_size() + 1 - static_cast<Index>(robot.tree.bodies.size());
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Joint& joint = robot.tree.bodies[body].joint;
    const auto row = static_cast<Index>(body) - 1;
    const double range_rad = joint.limits.position_max - joint.limits.position_min;
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const double time_s = motion.time_s(sample);
      const double at = motion.positions(base_positions + row, sample);
      const double speed =
          std::abs(motion.velocities(robot.tree.base_velocity_size() + row, sample));
      if (std::isfinite(range_rad)) {
        const bool is_low = at - joint.limits.position_min < joint.limits.position_max - at;
        const double limit = is_low ? joint.limits.position_min : joint.limits.position_max;
        least.add(
            {"joint-range", joint.name, time_s, at, limit,
             std::abs(limit - at) *
                 (at < joint.limits.position_min || at > joint.limits.position_max ? -1.0 : 1.0),
             "rad"},
            range_rad);
      }
      if (std::isfinite(joint.limits.speed_max)) {
        least.add({"joint-speed", joint.name, time_s, speed, joint.limits.speed_max,
                   joint.limits.speed_max - speed, "rad/s"},
                  joint.limits.speed_max);
      }
    }
  }
}

}  // namespace

std::vector<LeastMargin> least_margins(const Robot& robot, const Motion& motion,
                                       const HopperReport& report) {
  Least least;
  add_regions(report, least);
  add_transmissions(report, least);
  add_findings(report, least);
  add_joints(robot, motion, least);
  return least.sorted();
}

}  // namespace torquewright::hopper
