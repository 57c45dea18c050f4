// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hopper/calibration/figures.hpp"

namespace torquewright::hopper::calibration {

/// Values of the free variables, and how close they come to the published figures.
struct Candidate {
  std::vector<double> values;
  double worst_error = 0.0;  ///< Largest relative error over the targets.
};

/// Fits the free values by least squares from several starts; some may be held at a value.
/// Deterministic. If the figures can be met within their tolerance, the candidate does (as far as a
/// local method finds it). Empty where no values give inertias that bodies have.
struct Held {
  std::size_t index = 0;
  double value = 0.0;
};
std::optional<Candidate> nearest_candidate(const Question& question, std::optional<Held> held = {},
                                           const std::vector<double>& start = {});

bool meets(const Figures& figures, const std::optional<Candidate>& candidate);

/// One value of a free variable, and how close the others can then bring the figures.
struct ProfilePoint {
  double value = 0.0;
  std::optional<Candidate> best;
};

/// The valley along one free value, the others fitted anew at each point.
struct Profile {
  std::vector<ProfilePoint> points;  ///< Points of a grid over its bounds.
  struct Range {
    double low = 0.0;
    double high = 0.0;
  };
  /// Ranges in which the figures can be met; their ends are found by halving.
  std::vector<Range> ranges;
  bool is_determined = false;  ///< There is one range, narrower than a twentieth of the bounds.
};

Profile profile_of(const Question& question, std::size_t index,
                   const std::optional<Candidate>& best);

struct Calibration {
  std::optional<Candidate> best;
  bool is_met = false;
  /// Profiles by free value; empty where the figures cannot be met.
  std::vector<Profile> profiles;

  bool is_determined() const;
};

/// Requires at least one free value and one target.
Calibration calibrate(const Question& question);

}  // namespace torquewright::hopper::calibration
