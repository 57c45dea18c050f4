// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/replay_report/replay_report.hpp"

namespace torquewright::report {

/// What the page of a replay is made of.
struct ReplayPage {
  const hopper::Robot& robot;
  const hopper::Motion& motion;  ///< As it is planned.
  const hopper::Reference& reference;
  const hopper::Record& record;
  const hopper::ReplayReport& report;
};

}  // namespace torquewright::report
