// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/sampled_motion.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A change of a velocity that is less is no impact, but the solver's tolerance.
constexpr double kImpact = 1e-4;  // m/s or rad/s

/// a(s) = a0 + b s + c s^2 through what is at 0, 1/2 and 1.
template <typename Values>
struct Parabola {
  Values a0, b, c;

  Parabola(const Values& at_0, const Values& at_half, const Values& at_1)
      : a0(at_0),
        b(-3.0 * at_0 + 4.0 * at_half - at_1),
        c(2.0 * at_0 - 4.0 * at_half + 2.0 * at_1) {}
  Values at(double s) const { return a0 + s * b + s * s * c; }
  /// From 0 on, in units of the interval.
  Values integral(double s) const { return s * a0 + s * s / 2.0 * b + s * s * s / 3.0 * c; }
  Values second_integral(double s) const {
    return s * s / 2.0 * a0 + s * s * s / 6.0 * b + s * s * s * s / 12.0 * c;
  }
};

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
    const TreeMotion tree = tree_motion(
        plane_, phase.frame(), {instant.position, instant.velocity, instant.acceleration});
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

/// Whether the robot's velocity jumps from the phase before to this one.
bool begins_with_impact(const SagittalRobot& plane, const PlannedPhase& before,
                        const PlannedPhase& after) {
  const auto velocity = [&](const PlannedPhase& phase, const PlannedInstant& at) {
    return tree_motion(plane, phase.frame(), {at.position, at.velocity, at.acceleration}).velocity;
  };
  return (velocity(before, before.instants.back()) - velocity(after, after.instants.front()))
             .cwiseAbs()
             .maxCoeff() > kImpact;
}

}  // namespace

PlannedInstant instant_within(const PlannedPhase& phase, std::size_t interval, double share) {
  const PlannedInstant& a = phase.instants[2 * interval];
  const PlannedInstant& b = phase.instants[2 * interval + 1];
  const PlannedInstant& c = phase.instants[2 * interval + 2];
  const double h = c.time_s - a.time_s;
  const Parabola<VectorXd> acceleration(a.acceleration, b.acceleration, c.acceleration);
  PlannedInstant out;
  out.time_s = share == 1.0 ? c.time_s : a.time_s + share * h;
  out.acceleration = acceleration.at(share);
  out.velocity = a.velocity + h * acceleration.integral(share);
  out.position = a.position + h * share * a.velocity + h * h * acceleration.second_integral(share);
  out.drive_Nm = Parabola<VectorXd>(a.drive_Nm, b.drive_Nm, c.drive_Nm).at(share);
  out.contact_N = Parabola<Eigen::Matrix3Xd>(a.contact_N, b.contact_N, c.contact_N).at(share);
  out.bus_V = Parabola<double>(a.bus_V, b.bus_V, c.bus_V).at(share);
  return out;
}

Motion sampled_motion(const Robot& robot, const SagittalRobot& plane, const PlannedMotion& plan,
                      double sample_s) {
  Samples samples(robot, plane);
  for (std::size_t p = 0; p < plan.phases.size(); ++p) {
    const PlannedPhase& phase = plan.phases[p];
    if (p == 0 || begins_with_impact(plane, plan.phases[p - 1], phase)) {
      samples.add(phase, instant_within(phase, 0, 0.0));
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
