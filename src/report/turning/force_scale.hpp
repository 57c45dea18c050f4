// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::report {

/// How long the arrows of a motion's forces are: that of the greatest fits into the picture.
struct ForceScale {
  double greatest_N = 0.0;
  /// Lengths grow with the root of the force: a blow so hard that the usual forces would have no
  /// length beside it.
  bool is_root = false;

  /// Of the longest arrow.
  double share(double force_N) const;
  double power() const { return is_root ? 0.5 : 1.0; }
  /// For the legend.
  std::string words() const;
};

/// Forces of all contact points at all instants, those that press not among them: zeros do not
/// count.
ForceScale force_scale(std::vector<double> forces_N);

}  // namespace torquewright::report
