// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hopper/check/window_load.hpp"

namespace torquewright::hopper {

/// A signal that is constant over each of many steps, and impulses at their ends.
struct StepSignal {
  const std::vector<double>& times_s;  ///< Ascending: one more than steps.
  Eigen::VectorXd values;              ///< One a step,
  Eigen::VectorXd impulses;            ///< and what comes at its end: magnitudes, mostly zero.
};

/// The window of the greatest ( |integral of the values| + impulses ) / length of all of that
/// length, as greatest_window() finds it, the first of those alike; in one pass. A shorter signal
/// is one window.
WindowLoad greatest_step_window(const StepSignal& signal, double window_s);

}  // namespace torquewright::hopper
