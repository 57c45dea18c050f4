// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/sampled_motion.hpp"

#include <algorithm>
#include <cmath>

#include "hopper/planning/plane/planned_instant.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A change of a velocity that is less is no impact, but the solver's tolerance.
constexpr double kImpact = 1e-4;  // m/s or rad/s
// How far positions of the two rows of one impact may differ for who reads the motion
// (motion_reader.cpp), in m or rad.
constexpr double kSamePosition = 1e-6;

// Accelerations and torques jump where a point lets go; who reads samples joins them by straight
// lines, and over a millisecond at take-off those of the hopper turn it by 0.3 rad/s.
constexpr double kAfterChange_s = 1e-5;

/// Rows of a planar base as those of a spatial one.
VectorXd spatial_position(const VectorXd& planar) {
  VectorXd out(planar.size() + 4);
  const double half = 0.5 * planar[2];
  out << planar[0], 0.0, planar[1], std::cos(half), 0.0, std::sin(half), 0.0,
      planar.tail(planar.size() - 3);
  return out;
}

VectorXd spatial_rate(const VectorXd& planar) {
  VectorXd out(planar.size() + 3);
  out << planar[0], 0.0, planar[1], 0.0, planar[2], 0.0, planar.tail(planar.size() - 3);
  return out;
}

class Samples {
 public:
  Samples(const Robot& robot, const SagittalRobot& plane)
      : is_spatial_(robot.tree.base == dynamics::BaseKind::kSpatial), plane_(plane) {}

  void add(const PlannedPhase& phase, const PlannedInstant& instant) {
    const TreeMotion tree = tree_motion(plane_, phase.frame(),
                                        {instant.position, instant.velocity, instant.acceleration});
    times_s_.push_back(instant.time_s);
    positions_.push_back(is_spatial_ ? spatial_position(tree.position) : tree.position);
    velocities_.push_back(is_spatial_ ? spatial_rate(tree.velocity) : tree.velocity);
    accelerations_.push_back(is_spatial_ ? spatial_rate(tree.acceleration) : tree.acceleration);
    VectorXd touching(static_cast<Index>(phase.touches.size()));
    for (std::size_t i = 0; i < phase.touches.size(); ++i) {
      touching[static_cast<Index>(i)] = phase.touches[i] ? 1.0 : 0.0;
    }
    touching_.push_back(std::move(touching));
  }

  Motion motion(std::size_t joints) const {
    Motion out;
    out.times_s = times_s_;
    out.positions = columns(positions_);
    out.velocities = columns(velocities_);
    out.accelerations = columns(accelerations_);
    out.efforts = Eigen::MatrixXd::Zero(static_cast<Index>(joints), out.samples());
    out.touching = columns(touching_);
    out.has_effort.assign(joints, false);
    out.has_touching = true;
    for (Index sample = 1; sample < out.samples(); ++sample) {
      if (out.time_s(sample) == out.time_s(sample - 1)) out.breaks.push_back(sample);
    }
    return out;
  }

 private:
  static Eigen::MatrixXd columns(const std::vector<VectorXd>& vectors) {
    Eigen::MatrixXd out(vectors.front().size(), static_cast<Index>(vectors.size()));
    for (std::size_t i = 0; i < vectors.size(); ++i) out.col(static_cast<Index>(i)) = vectors[i];
    return out;
  }

  bool is_spatial_;
  const SagittalRobot& plane_;
  std::vector<double> times_s_;
  std::vector<VectorXd> positions_, velocities_, accelerations_, touching_;
};

double greatest_difference(const VectorXd& one, const VectorXd& other) {
  return (one - other).cwiseAbs().maxCoeff();
}

/// Whether the robot's velocity jumps from the phase before to this one, by their samples. Where
/// its place does as well that is no impact but what a search has left open.
bool begins_with_impact(const SagittalRobot& plane, const PlannedPhase& before,
                        const PlannedPhase& after) {
  const auto motion = [&](const PlannedPhase& phase, const PlannedInstant& at) {
    return tree_motion(plane, phase.frame(), {at.position, at.velocity, at.acceleration});
  };
  const TreeMotion one = motion(before, instant_within(before, before.intervals() - 1, 1.0));
  const TreeMotion other = motion(after, instant_within(after, 0, 0.0));
  return greatest_difference(one.velocity, other.velocity) > kImpact &&
         greatest_difference(one.position, other.position) <= kSamePosition;
}

}  // namespace

Motion sampled_motion(const Robot& robot, const SagittalRobot& plane, const PlannedMotion& plan,
                      double sample_s) {
  Samples samples(robot, plane);
  for (std::size_t p = 0; p < plan.phases.size(); ++p) {
    const PlannedPhase& phase = plan.phases[p];
    if (p == 0 || begins_with_impact(plane, plan.phases[p - 1], phase)) {
      samples.add(phase, instant_within(phase, 0, 0.0));
    } else {
      const double length_s = phase.instants[2].time_s - phase.begin_s();
      samples.add(phase, instant_within(phase, 0, kAfterChange_s / length_s));
    }
    for (std::size_t interval = 0; interval < phase.intervals(); ++interval) {
      const double length_s =
          phase.instants[2 * interval + 2].time_s - phase.instants[2 * interval].time_s;
      const int count = std::max(1, static_cast<int>(std::ceil(length_s / sample_s - 1e-9)));
      for (int i = 1; i <= count; ++i) {
        samples.add(phase, instant_within(phase, interval,
                                          i == count ? 1.0 : static_cast<double>(i) / count));
      }
    }
  }
  return samples.motion(robot.tree.bodies.size() - 1);
}

}  // namespace torquewright::hopper
