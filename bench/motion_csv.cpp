// SPDX-License-Identifier: Apache-2.0
#include "bench/motion_csv.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string_view>

namespace torquewright::bench {
namespace {

void print_head() {
  fmt::print(
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

}  // namespace

void print_motion(const char* comment, const std::vector<FlipSample>& samples) {
  fmt::print("{}", comment);
  print_head();
  const FlipSample* before = nullptr;
  for (const FlipSample& sample : samples) {
    // The flight's first sample is the stance's last.
    const bool repeated = before != nullptr && before->phase != FlipPhase::kFlight &&
                          sample.phase == FlipPhase::kFlight;
    if (!repeated) print_row(sample);
    before = &sample;
  }
}

}  // namespace torquewright::bench
