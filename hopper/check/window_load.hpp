// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// A signal over time that is linear between samples, with impulses at some of them, and what its
/// samples may have missed.
struct LoadSignal {
  const std::vector<double>& times_s;  ///< Times, not descending.
  Eigen::VectorXd values;              ///< Values, one for each time.
  Eigen::VectorXd impulses;            ///< Magnitudes of impulses, one for each time; mostly zero.
  Eigen::VectorXd doubts;  ///< Integral missing since the sample before, signed: these add up.
  Eigen::VectorXd bends;   ///< How far it may be off since the sample before, either way.
};

/// The window in which ( |integral of the values| + impulses ) / length is greatest, of all windows
/// of that length in the signal, wherever they begin (docs/derivations/whole_body_check.md eq.
/// (12)).
struct WindowLoad {
  double mean = 0.0;
  double time_s = 0.0;  ///< Time at which it begins.
  double without_impulses = 0.0;
  double doubt = 0.0;  ///< Doubt of its mean.
  double least = 0.0;  ///< The greatest of all windows' means less their doubt.
  double most = 0.0;   ///< The greatest of all windows' means plus their doubt.
};

/// Finds the greatest window. A signal shorter than the window is one window, its mean that of its
/// own length; one without duration has its values alone.
WindowLoad greatest_window(const LoadSignal& signal, double window_s);

}  // namespace torquewright::hopper
