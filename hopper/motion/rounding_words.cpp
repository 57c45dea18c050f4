// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/rounding_words.hpp"

#include <fmt/format.h>

#include "hopper/motion/slopes.hpp"

namespace torquewright::hopper {
namespace {

bool has_steps(const Motion& motion) {
  return motion.steps.size() > 0 && !motion.steps.isZero(0.0);
}

}  // namespace

std::string source_words(const Motion& motion) {
  const bool by_velocity = has_given_velocity(motion);
  const char* of = by_velocity ? "velocities" : "positions";
  if (!has_steps(motion)) return fmt::format("noisy {}", of);
  return fmt::format("{} in steps of {:.3g} ({})", of, motion.steps.maxCoeff(),
                     by_velocity ? "rad/s or m/s" : "rad or m");
}

std::string better_log(const Motion& motion) {
  const char* more = has_given_velocity(motion) ? "accelerations" : "velocities or accelerations";
  if (!has_steps(motion)) return fmt::format("less noise, or {} in the log,", more);
  return fmt::format(
      "finer steps (more bits, more digits), or {} in the log, not samples closer "
      "together,",
      more);
}

}  // namespace torquewright::hopper
