// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/joint_excess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kLimitRoundOff = 1e-9;  // relative to the limit, or to 1

}  // namespace

void JointExcess::Beyond::note(double value_now, double limit_now, double excess_now,
                               double time_now_s) {
  if (!(excess_now > kLimitRoundOff * std::max(1.0, std::abs(limit_now)))) return;
  ++samples;
  if (excess_now <= excess) return;
  *this = {excess_now, value_now, limit_now, time_now_s, samples};
}

void JointExcess::note_position(double position, double time_s) {
  const dynamics::JointLimits& limits = joint_.limits;
  position_.note(position, limits.position_min, limits.position_min - position, time_s);
  position_.note(position, limits.position_max, position - limits.position_max, time_s);
}

void JointExcess::note_speed(double speed, double time_s) {
  const double limit = joint_.limits.speed_max;
  speed_.note(speed, limit, std::abs(speed) - limit, time_s);
}

void JointExcess::note_effort(double effort, double time_s) {
  const double limit = joint_.limits.effort_max;
  effort_.note(effort, limit, std::abs(effort) - limit, time_s);
}

void JointExcess::add_to(std::vector<actuator::Finding>& findings, std::size_t samples) const {
  const bool turns = joint_.kind == dynamics::JointKind::kRevolute;
  add({"joint-range", "position", turns ? "rad" : "m"}, position_, samples, findings);
  add({"joint-speed", "speed", turns ? "rad/s" : "m/s"}, speed_, samples, findings);
  add({"joint-torque", turns ? "torque" : "force", turns ? "Nm" : "N"}, effort_, samples, findings);
}

void JointExcess::add(const Words& words, const Beyond& beyond, std::size_t samples,
                      std::vector<actuator::Finding>& findings) const {
  if (beyond.samples == 0) return;
  findings.push_back(
      {actuator::Severity::kViolation, words.rule, joint_.name, beyond.time_s, beyond.value,
       beyond.limit, words.unit,
       fmt::format("{}: {} of {:.6g} {} at t = {} s, limit {:.6g} {} ({} of {} samples "
                   "beyond)",
                   joint_.name, words.what, beyond.value, words.unit, io::time_text(beyond.time_s),
                   beyond.limit, words.unit, beyond.samples, samples)});
}

}  // namespace torquewright::hopper
