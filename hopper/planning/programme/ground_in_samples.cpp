// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/ground_in_samples.hpp"

#include <algorithm>

#include "hopper/planning/constraints/cone.hpp"
#include "hopper/planning/plane/sole_load.hpp"

namespace torquewright::hopper {
namespace {

double excess(const Site& phase, double share, const SoleLoad& load) {
  double most = 0.0;
  if (load.load_N() > kLeastLoad * phase.model.weight_N) {
    const double allowed = friction_of(phase);
    const double coefficient = allowed / (1.0 - phase.options.margins.friction);
    most = std::max(most, (load.friction() - allowed) / coefficient);
  }
  if (!phase.stance().is_flat()) return most;
  return std::max(most, edge_at(phase, share) - load.lesser_share());
}

}  // namespace

std::vector<double> ground_excess(const Site& phase, const PlannedPhase& planned,
                                  const std::vector<double>& times_s,
                                  const Eigen::MatrixXd& forces_N) {
  std::vector<double> most(planned.intervals(), 0.0);
  const bool has_forces = forces_N.cols() == static_cast<Eigen::Index>(times_s.size());
  if (phase.stance().is_flight() || !has_forces) return most;
  std::size_t i = 0;
  for (std::size_t sample = 0; sample < times_s.size() && i < most.size(); ++sample) {
    const double time_s = times_s[sample];
    while (i < most.size() && time_s >= planned.instants[2 * i + 2].time_s) ++i;
    if (i == most.size() || time_s <= planned.instants[2 * i].time_s) continue;
    const double share = (time_s - planned.begin_s()) / (planned.end_s() - planned.begin_s());
    const SoleLoad load = sole_load(phase.model.plane, forces_N, static_cast<Eigen::Index>(sample));
    most[i] = std::max(most[i], excess(phase, share, load));
  }
  return most;
}

}  // namespace torquewright::hopper
