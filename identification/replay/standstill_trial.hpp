// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "identification/replay/replay_case.hpp"
#include "identification/replay/starts.hpp"
#include "optimization/fit/local_fit.hpp"

namespace torquewright::identification {

/// A law of friction that may replace the known level.
struct Candidate {
  std::string effect;
  std::vector<optimization::FitVariable> variables;
  /// Converts the search's variables to the effect's parameters, in its order.
  std::function<std::vector<double>(std::span<const double>)> parameters;
};

/// Returns a candidate with Coulomb's level alone.
Candidate coulomb_candidate(double lowest_Nm, double highest_Nm, double start_Nm);

/// Returns a candidate with breakaway above the level; its variables are the excess over the level
/// in shares of it, and the speed at which it fades in shares of the log's.
Candidate stribeck_candidate(double level_Nm, double speed_rad_s);

/// Whether an effect is a friction level, which the candidates replace.
bool is_level(const actuator::Effect& effect);

/// Fits one candidate to the positions of windows. Keeps a reference to the log.
class StandstillTrial {
 public:
  using Indices = std::vector<std::size_t>;

  StandstillTrial(const ReplayCase& log, const actuator::Actuator& known, Candidate candidate);

  /// Returns the variables with which the positions of these windows are followed best.
  optimization::LocalFit fit(const Indices& windows, std::size_t starts) const;

  /// Converts the ends of a fit's starts to the effect's parameters.
  Starts starts_of(const optimization::LocalFit& fit) const;

  /// Sets the point at which the next fits begin.
  void begin_at(const std::vector<double>& point);

  actuator::Actuator of_point(std::span<const double> point) const;
  actuator::Actuator of_start() const;
  std::vector<double> parameters_of_start() const;
  const Candidate& candidate() const { return candidate_; }

  /// White's estimate over windows: A^-1 (sum g g') A^-1, where A holds the products of the errors'
  /// derivatives and g the windows' scores.
  Eigen::VectorXd standard_errors(const std::vector<double>& parameters,
                                  const Indices& windows) const;

 private:
  actuator::Actuator at(const std::vector<double>& parameters) const;
  Eigen::VectorXd slope(const std::vector<double>& parameters, Eigen::Index k, std::size_t w) const;

  const ReplayCase& log_;
  actuator::Actuator base_;
  Candidate candidate_;
};

}  // namespace torquewright::identification
