// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_plan/motion_information.hpp"

#include "identification/rollout/output_errors.hpp"

namespace torquewright::identification {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd information_of(const RobotModel& model, std::size_t limb,
                        const std::vector<FreeValue>& values, const CommandedMotion& motion,
                        double noise_rad) {
  const Log log = log_of({motion});
  const std::vector<Window> whole = {{0, 1, log.runs.front().time_s.size() - 2}};
  const VectorXd errors = output_errors_rad(log, model, limbs_of(model.load)[limb], whole);
  if (errors.size() == 0) return {};
  const MatrixXd slopes = slopes_of(log, model, values, limb, whole, errors);
  return slopes.transpose() * slopes / (noise_rad * noise_rad);
}

VectorXd known_before(const std::vector<FreeValue>& values) {
  VectorXd known(static_cast<Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double share = values[k].size / values[k].deviation;  // 0 where nothing is known
    known[static_cast<Index>(k)] = share * share;
  }
  return known;
}

}  // namespace torquewright::identification
