// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "learning/training/model.hpp"

namespace torquewright::learning {

/// Where an open episode is.
struct SavedCopy {
  std::uint64_t generator_state = 0;
  std::uint64_t episodes_begun = 0;
  std::vector<float> actions_taken;
  Eigen::VectorXd view;  ///< What was seen last, to know it again.
};

/// All that the next iteration depends on, but for sizes and options.
struct SavedState {
  std::int64_t iteration = 0;
  std::int64_t steps = 0;
  Model model;
  std::vector<SavedCopy> copies;
};

/// Writes a state: a line that says what it is, the fingerprint of sizes and options, and the
/// numbers as the machine holds them, lowest byte first.
void write_state(std::ostream& out, const std::string& fingerprint, const SavedState& state);

/// Reads what write_state() wrote into a state of the same sizes. Throws std::invalid_argument with
/// a sentence where it is something else; then `state` is of no use.
void read_state(std::istream& in, const std::string& fingerprint, SavedState& state);

}  // namespace torquewright::learning
