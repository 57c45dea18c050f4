// SPDX-License-Identifier: Apache-2.0
// Fields: as in urdf_reader.cpp.
#include "robot/urdf/urdf_limits.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {
namespace {

/// Ranges between these are those of joints in degrees: no arm turns more than four times, and who
/// writes thousands means none.
constexpr double kMostTurns = 4.0;
constexpr double kMeansNone_rad = 1000.0;

double turns_of(const dynamics::JointLimits& limits) {
  return (limits.position_max - limits.position_min) / (2.0 * std::numbers::pi);
}

bool seems_in_degrees(const dynamics::Joint& joint) {
  return joint.kind == dynamics::JointKind::kRevolute && turns_of(joint.limits) > kMostTurns &&
         joint.limits.position_max - joint.limits.position_min < kMeansNone_rad;
}

bool states(const Element& limit, const char* one, const char* other) {
  return find_attribute(limit, one) != nullptr || find_attribute(limit, other) != nullptr;
}

}  // namespace

void UrdfLimits::read(const Element& limit, bool has_range, DraftBody& draft) {
  if (has_range) read_range(limit, draft);
  const double effort = bound(limit, "effort");
  const double speed = bound(limit, "velocity");
  const std::string& joint = draft.body.joint.name;
  if (effort == 0 && find_attribute(limit, "effort") != nullptr) without_effort_.push_back(joint);
  if (speed == 0 && find_attribute(limit, "velocity") != nullptr) without_speed_.push_back(joint);
  if (effort > 0) draft.body.joint.limits.effort_max = effort;
  if (speed > 0) draft.body.joint.limits.speed_max = speed;
}

void UrdfLimits::read_none(DraftBody& draft) {
  if (!welds_locked_) {
    freed_.push_back(draft.body.joint.name);
    return;
  }
  draft.body.joint.limits.position_min = draft.body.joint.limits.position_max = 0;
  weld(false, draft);
}

void UrdfLimits::read_range(const Element& limit, DraftBody& draft) {
  dynamics::JointLimits& limits = draft.body.joint.limits;
  const double lower = faults_->limit(limit, "lower").value_or(0);
  const double upper = faults_->limit(limit, "upper").value_or(0);
  if (lower > upper || (lower == upper && std::isinf(lower))) {
    faults_->report(limit, fmt::format("lower {} is not below upper {}", lower, upper));
    return;
  }
  const bool is_stated = states(limit, "lower", "upper");
  const bool is_empty =
      lower == 0 && upper == 0 && (!is_stated || states(limit, "effort", "velocity"));
  if (is_empty && !welds_locked_) {
    freed_.push_back(draft.body.joint.name);
    return;
  }
  limits.position_min = lower;
  limits.position_max = upper;
  if (lower == upper) weld(is_stated, draft);
  const dynamics::Joint& joint = draft.body.joint;
  if (!seems_in_degrees(joint)) return;
  wide_.push_back(
      fmt::format("joint \"{}\" ranges from {:g} to {:g} rad, {:.3g} turns: degrees? URDF "
                  "has radians",
                  joint.name, lower, upper, turns_of(limits)));
}

/// Zero stands for "not known" in most files.
double UrdfLimits::bound(const Element& limit, const char* name) {
  const double bound = faults_->limit(limit, name).value_or(0);
  if (bound < 0) {
    faults_->report(limit, fmt::format("{}={} is below 0; it bounds both directions, and 0 says "
                                       "that it is not known",
                                       name, bound));
  }
  return bound;
}

/// A range of one position is none that a joint could move in.
void UrdfLimits::weld(bool is_stated, DraftBody& draft) {
  dynamics::Joint& joint = draft.body.joint;
  const double position = joint.limits.position_min;
  draft.is_welded = true;
  if (joint.kind == dynamics::JointKind::kPrismatic) {
    joint.p_PB_m += joint.R_PB * (position * joint.axis);
  } else {
    joint.R_PB = joint.R_PB * Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
  }
  welded_.push_back(fmt::format("joint \"{}\" is welded at {}: its lower and upper limits are {}",
                                joint.name, position,
                                is_stated ? "the same" : "left out, and mean zero"));
}

std::vector<std::string> UrdfLimits::notes() const {
  std::vector<std::string> notes = welded_;
  notes.insert(notes.end(), wide_.begin(), wide_.end());
  for (const auto& [word, joints] :
       {std::pair{"effort", &without_effort_}, {"velocity", &without_speed_}}) {
    if (joints->empty()) continue;
    notes.push_back(fmt::format("{}=\"0\" is read as not known, of {} joint{}: {}", word,
                                joints->size(), joints->size() == 1 ? "" : "s", listed(*joints)));
  }
  if (freed_.empty()) return notes;
  notes.push_back(
      fmt::format("these are joints without a range: their lower and upper limits are left out or "
                  "zero, which simulators read as none (--weld-locked holds them at zero): {}",
                  listed(freed_)));
  return notes;
}

}  // namespace torquewright::hopper
