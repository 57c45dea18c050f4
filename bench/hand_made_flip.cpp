// SPDX-License-Identifier: Apache-2.0
// A flip of specs/robot/hopper.json as a motion for `torquewright hopper check`: physical, and no
// optimum of anything. Its numbers were sought until ground, joint ranges and torques were kept,
// and rounded; two of them are closed here so that the foot meets the ground flat.
//   hand_made_flip specs/robot/hopper.json > specs/trajectory/hopper_flip.csv
#include <fmt/core.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>

#include "bench/flip_motion.hpp"
#include "dynamics/point.hpp"
#include "hopper/robot/robot_spec.hpp"

namespace torquewright::bench {
namespace {

constexpr double kLongestStep_s = 0.002;

FlipNumbers sought() {
  return {0.571922,
          0.053591,
          0.508387,
          0.600002,
          {1.858932, 1.858932, 1.858932, 1.907725, 2.025716, 2.113043, 2.302972,
           2.214322, 2.131693, 1.980875, 1.700753, 1.204381, 1.680942, 2.249229,
           2.261533, 2.259063, 2.257779, 2.264958, 2.214402, 2.259413},
          {-0.245751, -0.245751, -0.245751, -0.283774, -0.355254, -0.440410, -0.516259,
           -0.547157, -0.604286, -0.540874, -0.816109, -0.998869, -0.160639, 0.269957,
           0.652792,  0.697134,  0.699820,  0.531338,  0.268195,  0.126911},
          {2.253880, 2.239531, 2.295604, 2.000002, 2.000002, 2.000002},
          {0.045641, -0.029245, -0.108248, -0.167468, -0.167468, -0.167468}};
}

/// As many that the splines' knots (flip_motion.cpp) are at samples.
std::vector<int> steps_of(const FlipNumbers& numbers) {
  const auto steps = [](double duration_s, int multiple_of) {
    return multiple_of * static_cast<int>(std::ceil(duration_s / kLongestStep_s / multiple_of));
  };
  return {steps(numbers.flat_s, 20), steps(numbers.heel_s, 4), steps(numbers.flight_s, 100),
          steps(numbers.landing_s, 20)};
}

/// How far the sole is from flat (turned by one turn) and from the ground at the end of the flight.
Eigen::Vector2d miss(FlipMaker& maker, const FlipNumbers& numbers) {
  const std::vector<FlipSample> samples = maker.motion(numbers, steps_of(numbers));
  FlipSample last;
  for (const FlipSample& sample : samples) {
    if (sample.phase == FlipPhase::kFlight) last = sample;
  }
  maker.state().set(last.position, last.velocity);
  const double height_m = dynamics::point_position_m(maker.state(), {3, {0, 0, -0.08}}).z();
  return {last.position.segment(2, 3).sum() - 2 * std::numbers::pi, height_m};
}

/// Newton's method on the time of flight and the knee's angle at touch-down.
void close(FlipMaker& maker, FlipNumbers& numbers) {
  constexpr double kChange = 1e-6;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d now = miss(maker, numbers);
    Eigen::Matrix2d slope;
    FlipNumbers other = numbers;
    other.flight_s += kChange;
    slope.col(0) = (miss(maker, other) - now) / kChange;
    other = numbers;
    other.knee_rad.back() += kChange;
    slope.col(1) = (miss(maker, other) - now) / kChange;
    const Eigen::Vector2d step = slope.fullPivLu().solve(now);
    numbers.flight_s -= step[0];
    numbers.knee_rad.back() -= step[1];
  }
}

void print_head() {
  fmt::print(
      "# One-legged hopper, front flip: take-off with a flat foot and then on its heel, flight,\n"
      "# landing on the flat foot one turn later. Made by bench/hand_made_flip; in the plane of x\n"
      "# and z, and no optimum. Two rows at touch-down: before and after the impact.\n"
      "time_s,base_x_position_m,base_y_position_m,base_z_position_m,base_qw_position,"
      "base_qx_position,base_qy_position,base_qz_position,knee_position_rad,"
      "ankle_pitch_position_rad,ankle_roll_position_rad");
  for (const auto& [rate, linear, turning] :
       {std::array{"velocity", "m_s", "rad_s"}, std::array{"acceleration", "m_s2", "rad_s2"}}) {
    for (const char* axis : {"x", "y", "z"}) fmt::print(",base_{}_{}_{}", axis, rate, linear);
    for (const char* axis : {"x", "y", "z"}) {
      fmt::print(",base_angular_{}_{}_{}", axis, rate, turning);
    }
    for (const char* joint : {"knee", "ankle_pitch", "ankle_roll"}) {
      fmt::print(",{}_{}_{}", joint, rate, turning);
    }
  }
  fmt::print("\n");
}

void print_rate(const Eigen::VectorXd& rate) {
  fmt::print(",{:.9g},0,{:.9g},0,{:.9g},0,{:.9g},{:.9g},0", rate[0], rate[1], rate[2], rate[3],
             rate[4]);
}

void print_row(const FlipSample& sample) {
  const double half_rad = 0.5 * sample.position[2];
  fmt::print("{:.9g},{:.9g},0,{:.9g},{:.9g},0,{:.9g},0,{:.9g},{:.9g},0", sample.time_s,
             sample.position[0], sample.position[1], std::cos(half_rad), std::sin(half_rad),
             sample.position[3], sample.position[4]);
  print_rate(sample.velocity);
  print_rate(sample.acceleration);
  fmt::print("\n");
}

void run(const char* robot_file) {
  const hopper::ReadRobot read = hopper::read_robot(robot_file);
  FlipMaker maker(read.robot);
  FlipNumbers numbers = sought();
  close(maker, numbers);
  print_head();
  const FlipSample* before = nullptr;
  const std::vector<FlipSample> samples = maker.motion(numbers, steps_of(numbers));
  for (const FlipSample& sample : samples) {
    // The flight's first sample is the stance's last.
    const bool repeated = before != nullptr && before->phase != FlipPhase::kFlight &&
                          sample.phase == FlipPhase::kFlight;
    if (!repeated) print_row(sample);
    before = &sample;
  }
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "hand_made_flip ROBOT\n");
    return 2;
  }
  try {
    torquewright::bench::run(arguments[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
