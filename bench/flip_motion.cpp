// SPDX-License-Identifier: Apache-2.0
#include "bench/flip_motion.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"

namespace torquewright::bench {
namespace {

using dynamics::BodyPoint;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Rows of the planar tree.
constexpr Eigen::Index kPitch = 2;
constexpr Eigen::Index kKnee = 3;
constexpr Eigen::Index kAnkle = 4;
constexpr Eigen::Index kRows = 6;
constexpr std::size_t kCross = 2;
constexpr std::size_t kFoot = 3;
const Vector3d kSole{0, 0, -0.08};
const Vector3d kHeel{-0.08, 0, -0.08};

dynamics::Tree planar(dynamics::Tree tree) {
  tree.base = dynamics::BaseKind::kPlanar;
  return tree;
}

std::vector<double> breaks_of(const std::vector<std::pair<double, std::vector<double>>>& parts) {
  std::vector<double> breaks{0.0};
  for (const auto& [duration_s, shares] : parts) {
    const double from_s = breaks.back();
    if (duration_s == 0) continue;
    for (const double share : shares) breaks.push_back(from_s + share * duration_s);
  }
  return breaks;
}

}  // namespace

struct FlipMaker::Joints {
  SplinePoint knee;
  SplinePoint ankle;
};

/// A point of the foot and where it is held.
struct FlipMaker::Hold {
  Vector3d p_B_m;
  double x_m;
};

FlipMaker::FlipMaker(const hopper::Robot& robot) : state_(planar(robot.tree)), body_(robot) {}

void FlipMaker::set(const Joints& joints, const Vector3d& base, const Vector3d& rate) {
  VectorXd position(kRows);
  VectorXd velocity(kRows);
  position << base, joints.knee.value, joints.ankle.value, 0;
  velocity << rate, joints.knee.rate, joints.ankle.rate, 0;
  state_.set(position, velocity);
}

/// The base's motion that keeps a point of the foot where it is, at height 0. sample.acceleration
/// must hold the pitch's.
void FlipMaker::hold(const Joints& joints, const Hold& hold, double pitch, double rate,
                     FlipSample& sample) {
  const BodyPoint point{kFoot, hold.p_B_m};
  sample.acceleration[kKnee] = joints.knee.second_rate;
  sample.acceleration[kAnkle] = joints.ankle.second_rate;
  sample.acceleration[0] = sample.acceleration[1] = 0;
  set(joints, {0, 0, pitch}, {0, 0, rate});
  const Vector3d place_m = dynamics::point_position_m(state_, point);
  const Vector3d velocity_m_s = dynamics::point_velocity_m_s(state_, point);
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, kRows);
  dynamics::point_jacobian(state_, point, jacobian);
  const Vector3d acceleration_m_s2 =
      jacobian * sample.acceleration + dynamics::point_bias_acceleration_m_s2(state_, point);
  sample.position = VectorXd::Zero(kRows);
  sample.position << hold.x_m - place_m.x(), -place_m.z(), pitch, joints.knee.value,
      joints.ankle.value, 0;
  sample.velocity = VectorXd::Zero(kRows);
  sample.velocity << -velocity_m_s.x(), -velocity_m_s.z(), rate, joints.knee.rate,
      joints.ankle.rate, 0;
  sample.acceleration[0] = -acceleration_m_s2.x();
  sample.acceleration[1] = -acceleration_m_s2.z();
}

FlipLoad FlipMaker::load(const FlipSample& sample) {
  state_.set(sample.position, sample.velocity);
  VectorXd force(kRows);
  dynamics::inverse_dynamics(state_, sample.acceleration, force);
  FlipLoad load{force[0], force[1], 0, force[kKnee], force[kAnkle]};
  if (sample.phase == FlipPhase::kFlight) return load;
  // From the base's origin, which is the knee, to the world's and to the ankle.
  load.moment_Nm =
      force[kPitch] + sample.position[1] * load.force_x_N - sample.position[0] * load.force_z_N;
  const Vector3d ankle_m = dynamics::point_position_m(state_, {kCross, Vector3d::Zero()});
  load.knee_Nm -= force[kPitch];
  load.ankle_Nm -= load.moment_Nm - ankle_m.z() * load.force_x_N + ankle_m.x() * load.force_z_N;
  return load;
}

/// Of the ground about +y and the point at height 0.
double FlipMaker::ground_moment(const FlipSample& sample, double x_m) {
  const FlipLoad of = load(sample);
  return of.moment_Nm + x_m * of.force_z_N;
}

/// Second rate of the pitch with which the ground has no moment about the heel.
double FlipMaker::heel_rate(const Joints& joints, double x_m, double pitch, double rate) {
  FlipSample trial;
  trial.acceleration = VectorXd::Zero(kRows);
  hold(joints, {kHeel, x_m}, pitch, rate, trial);
  const double at_zero = ground_moment(trial, x_m);
  trial.acceleration[kPitch] = 1;
  hold(joints, {kHeel, x_m}, pitch, rate, trial);
  return -at_zero / (ground_moment(trial, x_m) - at_zero);
}

double FlipMaker::flight_rate(const Joints& joints, double momentum_Nm_s) {
  set(joints, Vector3d::Zero(), Vector3d::Zero());
  const dynamics::Centroid still = dynamics::centroid(state_);
  return (momentum_Nm_s - still.angular_momentum_Nm_s.y()) / still.inertia_kg_m2(1, 1);
}

void FlipMaker::fly(FlipSample& sample, const Vector3d& center_m, const Vector3d& velocity_m_s,
                    double pitch, double momentum_Nm_s, const Joints& joints) {
  const double rate = flight_rate(joints, momentum_Nm_s);
  set(joints, {0, 0, pitch}, {0, 0, rate});
  const dynamics::Centroid relative = dynamics::centroid(state_);
  const Vector3d place_m = center_m - relative.position_m;
  const Vector3d speed_m_s = velocity_m_s - relative.velocity_m_s;
  set(joints, {place_m.x(), place_m.z(), pitch}, {speed_m_s.x(), speed_m_s.z(), rate});
  sample.position = VectorXd::Zero(kRows);
  sample.position << place_m.x(), place_m.z(), pitch, joints.knee.value, joints.ankle.value, 0;
  sample.velocity = state_.velocity();
  // Nothing acts on the base: M_bb a_b + (what the joints' accelerations and velocities need) = 0.
  sample.acceleration = VectorXd::Zero(kRows);
  sample.acceleration[kKnee] = joints.knee.second_rate;
  sample.acceleration[kAnkle] = joints.ankle.second_rate;
  VectorXd force(kRows);
  Eigen::MatrixXd mass(kRows, kRows);
  dynamics::inverse_dynamics(state_, sample.acceleration, force);
  dynamics::mass_matrix(state_, mass);
  const Matrix3d base = mass.topLeftCorner<3, 3>();
  sample.acceleration.head<3>() = -base.ldlt().solve(force.head<3>().eval());
}

FlipImpact FlipMaker::impact(const FlipSample& before) {
  // Of the whole body with its rotors, without what leaves the plane.
  const double half_rad = 0.5 * before.position[kPitch];
  VectorXd position(10);
  position << before.position[0], 0, before.position[1], std::cos(half_rad), 0, std::sin(half_rad),
      0, before.position.tail<3>();
  if (!body_.set(position, VectorXd::Zero(9))) throw std::runtime_error("ankle out of reach");
  Eigen::MatrixXd whole(9, 9);
  body_.mass_matrix(whole);
  const std::array<Eigen::Index, 5> in_plane{0, 2, 4, 6, 7};
  const Eigen::MatrixXd mass = whole(in_plane, in_plane);
  state_.set(before.position, before.velocity);
  const BodyPoint sole{kFoot, kSole};
  Eigen::Matrix<double, 3, Eigen::Dynamic> move(3, kRows);
  Eigen::Matrix<double, 3, Eigen::Dynamic> turn(3, kRows);
  dynamics::point_jacobian(state_, sole, move);
  dynamics::rotation_jacobian(state_, kFoot, turn);
  Eigen::Matrix<double, 3, 5> rows;
  rows << move.row(0).head<5>(), move.row(2).head<5>(), turn.row(1).head<5>();
  const Eigen::MatrixXd response = mass.ldlt().solve(rows.transpose());
  const Matrix3d compliance = rows * response;
  const Vector3d impulse = -compliance.ldlt().solve((rows * before.velocity.head<5>()).eval());
  const double x_m = dynamics::point_position_m(state_, sole).x();
  FlipImpact result;
  result.velocity = before.velocity;
  result.velocity.head<5>() += response * impulse;
  result.impulse_x_N_s = impulse[0];
  result.impulse_z_N_s = impulse[1];
  result.moment_Nm_s = impulse[2] - x_m * impulse[1];
  return result;
}

std::vector<FlipSample> FlipMaker::motion(const FlipNumbers& numbers,
                                          const std::vector<int>& steps) {
  const std::vector<double> breaks =
      breaks_of({{numbers.flat_s, {0.3, 0.55, 0.75, 0.9, 1.0}},
                 {numbers.heel_s, {0.25, 0.5, 0.75, 1.0}},
                 {numbers.flight_s, {0.08, 0.17, 0.28, 0.42, 0.56, 0.7, 0.85, 1.0}}});
  const CubicSpline knee(breaks, numbers.knee_rad);
  const CubicSpline ankle(breaks, numbers.ankle_rad);
  const auto joints = [&](double time_s) { return Joints{knee.at(time_s), ankle.at(time_s)}; };
  std::vector<FlipSample> samples;

  for (int i = 0; i <= steps[0]; ++i) {
    FlipSample sample{FlipPhase::kFlat, numbers.flat_s * i / steps[0], {}, {}, {}};
    const Joints now = joints(sample.time_s);
    sample.acceleration = VectorXd::Zero(kRows);
    sample.acceleration[kPitch] = -now.knee.second_rate - now.ankle.second_rate;
    hold(now, {kSole, 0}, -now.knee.value - now.ankle.value, -now.knee.rate - now.ankle.rate,
         sample);
    samples.push_back(sample);
  }
  double time_s = numbers.flat_s;
  double pitch = samples.back().position[kPitch];
  double rate = samples.back().velocity[kPitch];
  for (int i = 1; numbers.heel_s > 0 && i <= steps[1]; ++i) {  // classical Runge-Kutta
    const double h = numbers.heel_s / steps[1];
    const Joints begin = joints(time_s);
    time_s = numbers.flat_s + numbers.heel_s * i / steps[1];
    const Joints middle = joints(time_s - 0.5 * h);
    const Joints end = joints(time_s);
    const double x = kHeel.x();
    const double k1 = heel_rate(begin, x, pitch, rate);
    const double k2 = heel_rate(middle, x, pitch + 0.5 * h * rate, rate + 0.5 * h * k1);
    const double k3 =
        heel_rate(middle, x, pitch + 0.5 * h * rate + 0.25 * h * h * k1, rate + 0.5 * h * k2);
    const double k4 = heel_rate(end, x, pitch + h * rate + 0.5 * h * h * k2, rate + h * k3);
    pitch += h * rate + h * h / 6 * (k1 + k2 + k3);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    FlipSample sample{FlipPhase::kHeel, time_s, {}, {}, VectorXd::Zero(kRows)};
    sample.acceleration[kPitch] = heel_rate(end, x, pitch, rate);
    hold(end, {kHeel, x}, pitch, rate, sample);
    samples.push_back(sample);
  }

  state_.set(samples.back().position, samples.back().velocity);
  const dynamics::Centroid start = dynamics::centroid(state_);
  const double momentum_Nm_s = start.angular_momentum_Nm_s.y();
  const Vector3d gravity{0, 0, -state_.tree().gravity_m_s2};
  for (int i = 0; i <= steps[2]; ++i) {
    const double h = numbers.flight_s / steps[2];
    const double flown_s = numbers.flight_s * i / steps[2];
    const Joints now = joints(time_s + flown_s);
    if (i > 0) {  // Simpson's rule: the rate depends on the joints alone
      pitch += h / 6 *
               (flight_rate(joints(time_s + flown_s - h), momentum_Nm_s) +
                4 * flight_rate(joints(time_s + flown_s - 0.5 * h), momentum_Nm_s) +
                flight_rate(now, momentum_Nm_s));
    }
    FlipSample sample{FlipPhase::kFlight, time_s + flown_s, {}, {}, {}};
    fly(sample, start.position_m + start.velocity_m_s * flown_s + 0.5 * flown_s * flown_s * gravity,
        start.velocity_m_s + flown_s * gravity, pitch, momentum_Nm_s, now);
    samples.push_back(sample);
  }

  const FlipSample down = samples.back();
  const FlipImpact stop = impact(down);
  const double sole_x_m = dynamics::point_position_m(state_, {kFoot, kSole}).x();
  const std::vector<double> landing_breaks =
      breaks_of({{numbers.landing_s, {0.1, 0.25, 0.45, 0.7, 1.0}}});
  const auto landing = [&](Eigen::Index row, std::vector<double> controls) {
    const double first = down.position[row];
    const double second = first + stop.velocity[row] * landing_breaks[1] / 3;
    controls.insert(controls.begin(), {first, second});
    return CubicSpline(landing_breaks, controls);
  };
  const CubicSpline knee_after = landing(kKnee, numbers.landing_knee_rad);
  const CubicSpline ankle_after = landing(kAnkle, numbers.landing_ankle_rad);
  for (int i = 0; i <= steps[3]; ++i) {
    const double stood_s = numbers.landing_s * i / steps[3];
    FlipSample sample{FlipPhase::kLanding, down.time_s + stood_s, {}, {}, VectorXd::Zero(kRows)};
    const Joints now{knee_after.at(stood_s), ankle_after.at(stood_s)};
    sample.acceleration[kPitch] = -now.knee.second_rate - now.ankle.second_rate;
    hold(now, {kSole, sole_x_m}, numbers.turn_rad - now.knee.value - now.ankle.value,
         -now.knee.rate - now.ankle.rate, sample);
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace torquewright::bench
