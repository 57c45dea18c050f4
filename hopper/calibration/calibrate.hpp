// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hopper/calibration/figures.hpp"

namespace torquewright::hopper::calibration {

/// Free values and how near they come to the figures.
struct Candidate {
  std::vector<double> values;
  double worst_error = 0.0;  ///< Largest magnitude over the targets, relative.
};

/// Least squares over the free values, from several starts; some may be held at a value.
/// Deterministic. If the figures can be met within their tolerance, the candidate does (as far as a
/// local method finds it). Empty where no values give inertias that bodies have.
struct Held {
  std::size_t index = 0;
  double value = 0.0;
};
std::optional<Candidate> nearest_candidate(const Question& question, std::optional<Held> held = {},
                                           const std::vector<double>& start = {});

bool meets(const Figures& figures, const std::optional<Candidate>& candidate);

/// Where a free value stands and how near the others can bring the figures to it.
struct ProfilePoint {
  double value = 0.0;
  std::optional<Candidate> best;
};

/// Along one free value, the others fitted anew at each point: the valley.
struct Profile {
  std::vector<ProfilePoint> points;  ///< A grid over its bounds.
  struct Range {
    double low = 0.0;
    double high = 0.0;
  };
  std::vector<Range> ranges;   ///< Where the figures can be met; ends found by halving.
  bool is_determined = false;  ///< One range, narrower than a twentieth of the bounds.
};

Profile profile_of(const Question& question, std::size_t index,
                   const std::optional<Candidate>& best);

struct Calibration {
  std::optional<Candidate> best;
  bool is_met = false;
  std::vector<Profile> profiles;  ///< By free value; empty where the figures cannot be met.

  bool is_determined() const;
};

/// Requires at least one free value and one target.
Calibration calibrate(const Question& question);

}  // namespace torquewright::hopper::calibration
