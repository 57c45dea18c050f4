// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

namespace torquewright::oracles {

/// amplitude sin(order angle + phase). The amplitude is a torque [N m], or a ratio of the load.
struct Harmonic {
  double order = 0.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;
};

/// A sum of harmonics; empty: zero everywhere.
struct Harmonics {
  std::vector<Harmonic> terms;

  double at(double angle_rad) const {
    double sum = 0.0;
    for (const Harmonic& term : terms) {
      sum += term.amplitude * std::sin(term.order * angle_rad + term.phase_rad);
    }
    return sum;
  }
};

}  // namespace torquewright::oracles
