// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/replay_case.hpp"

#include <cmath>

namespace torquewright::identification {

std::vector<double> ReplayCase::losses(const actuator::Actuator& actuator,
                                       const std::vector<std::size_t>& which) const {
  std::vector<double> losses;
  for (const std::size_t w : which) {
    const Eigen::VectorXd errors = replay.errors(actuator, windows[w]);
    losses.push_back(errors.squaredNorm() / static_cast<double>(errors.size()));
  }
  return losses;
}

std::vector<std::size_t> ReplayCase::chosen(bool held_out) const {
  std::vector<std::size_t> indices;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    if (windows[w].is_held_out == held_out) indices.push_back(w);
  }
  return indices;
}

double rms_of_losses(const std::vector<double>& losses) {
  double sum = 0.0;
  for (const double loss : losses) sum += loss;
  return losses.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(losses.size()));
}

}  // namespace torquewright::identification
