// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/reference.hpp"
#include "hopper/trials/trial.hpp"

namespace torquewright::hopper {

/// State in which a run begins.
struct RunStart {
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
};

/// The motion's first sample with what a trial adds to its joints, within their ranges; the base is
/// raised or lowered so that the lowest contact point stays as high as it was.
RunStart start_of(const Robot& robot, const Reference& reference, const Trial& trial);

}  // namespace torquewright::hopper
