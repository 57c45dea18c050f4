// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// A signal over time that is straight between samples, with impulses at some of them, and what its
/// samples may have missed.
struct LoadSignal {
  const std::vector<double>& times_s;  ///< Do not descend.
  Eigen::VectorXd values;              ///< One a time.
  Eigen::VectorXd impulses;            ///< Magnitudes, one a time; mostly zero.
  Eigen::VectorXd doubts;  ///< Integral missing since the sample before, signed: they add up.
  Eigen::VectorXd bends;   ///< How far it may be off since the sample before, either way.
};

/// The window in which ( |integral of the values| + impulses ) / length is greatest, of all windows
/// of that length that lie in the signal, wherever they begin. docs/derivations/whole_body_check.md
/// eq. (12).
struct WindowLoad {
  double mean = 0.0;
  double time_s = 0.0;  ///< At which it begins.
  double without_impulses = 0.0;
  double doubt = 0.0;  ///< Of its mean.
  double least = 0.0;  ///< The greatest of all windows' means less their doubt,
  double most = 0.0;   ///< and with it.
};

/// A signal shorter than the window is one window, its mean that of its own length; one without
/// duration has its values alone.
WindowLoad greatest_window(const LoadSignal& signal, double window_s);

}  // namespace torquewright::hopper
