// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/narrowed_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr int kSteps = 200;    // along a range
constexpr int kHalvings = 40;  // to rounding
constexpr double kTurn = 2 * std::numbers::pi;

/// A crank's position is known but for whole turns.
bool is_within(double position, const dynamics::JointLimits& limits) {
  if (!std::isfinite(limits.position_min) || !std::isfinite(limits.position_max)) return true;
  const double middle = (limits.position_min + limits.position_max) / 2;
  return std::abs(std::remainder(position - middle, kTurn)) <= limits.position_max - middle;
}

class Narrower {
 public:
  Narrower(const Mechanism& mechanism, const std::vector<dynamics::Joint*>& joints,
           const std::vector<dynamics::JointLimits>& cranks)
      : mechanism_(mechanism), cranks_(cranks), home_(static_cast<Index>(joints.size())) {
    for (Index k = 0; k < home_.size(); ++k) {
      const auto& limits = joints[static_cast<std::size_t>(k)]->limits;
      home_[k] = std::clamp(0.0, limits.position_min, limits.position_max);
    }
  }

  /// The last position towards that end where all cranks are within their ranges; none where the
  /// end is reached, or where no crank's range ends the way to it.
  std::optional<double> last_before(Index joint, double end) const {
    if (!std::isfinite(end) || reached(joint, end) || !cranks_are_within(joint, home_[joint])) {
      return std::nullopt;
    }
    double inside = home_[joint], outside = end;
    for (int step = 1; step <= kSteps; ++step) {
      const double at = home_[joint] + (end - home_[joint]) * step / kSteps;
      if (cranks_are_within(joint, at)) {
        inside = at;
        continue;
      }
      outside = at;
      break;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (inside + outside) / 2;
      (cranks_are_within(joint, middle) ? inside : outside) = middle;
    }
    // The linkage's own end, and no crank's.
    const bool is_cranks_end = reached(joint, outside);
    return is_cranks_end ? std::optional<double>(inside) : std::nullopt;
  }

 private:
  std::optional<Transfer> at(Index joint, double position) const {
    SmallVector posture = home_;
    posture[joint] = position;
    return mechanism_.transfer(posture, SmallVector::Zero(home_.size()));
  }
  bool reached(Index joint, double position) const { return at(joint, position).has_value(); }
  bool cranks_are_within(Index joint, double position) const {
    const auto transfer = at(joint, position);
    if (!transfer) return false;
    for (std::size_t i = 0; i < cranks_.size(); ++i) {
      if (!is_within(transfer->actuator_position_rad[static_cast<Index>(i)], cranks_[i])) {
        return false;
      }
    }
    return true;
  }

  const Mechanism& mechanism_;
  const std::vector<dynamics::JointLimits>& cranks_;
  SmallVector home_;
};

}  // namespace

std::vector<std::string> narrow_to_cranks(const Mechanism& mechanism,
                                          const std::vector<dynamics::Joint*>& joints,
                                          const std::vector<dynamics::JointLimits>& cranks) {
  std::vector<std::string> notes;
  const Narrower narrower(mechanism, joints, cranks);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    dynamics::JointLimits& limits = joints[k]->limits;
    const dynamics::JointLimits stated = limits;
    const auto joint = static_cast<Index>(k);
    if (const auto least = narrower.last_before(joint, stated.position_min)) {
      limits.position_min = *least;
    }
    if (const auto most = narrower.last_before(joint, stated.position_max)) {
      limits.position_max = *most;
    }
    if (limits.position_min == stated.position_min && limits.position_max == stated.position_max) {
      continue;
    }
    const char* unit = joints[k]->kind == dynamics::JointKind::kRevolute ? "rad" : "m";
    notes.push_back(fmt::format(
        "\"{}\" is narrowed from {:.4g} .. {:.4g} to {:.4g} .. {:.4g} {}, where its cranks' own "
        "ranges end: beyond, the linkage is in line or open",
        joints[k]->name, stated.position_min, stated.position_max, limits.position_min,
        limits.position_max, unit));
  }
  return notes;
}

void narrow_held(const Mechanism& mechanism, const std::vector<std::size_t>& held,
                 const std::vector<std::size_t>& turned, const std::vector<DraftBody>& draft,
                 std::vector<DraftBody>& narrowed, std::vector<std::string>& notes) {
  std::vector<dynamics::Joint*> joints;
  for (const std::size_t joint : held) joints.push_back(&narrowed[joint].body.joint);
  std::vector<dynamics::JointLimits> cranks;
  for (const std::size_t crank : turned) cranks.push_back(draft[crank].body.joint.limits);
  for (std::string& note : narrow_to_cranks(mechanism, joints, cranks)) {
    notes.push_back(std::move(note));
  }
}

}  // namespace torquewright::hopper
