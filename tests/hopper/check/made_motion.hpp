// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper::check_test {

/// A motion that a test makes by hand, and all that a check knows of it.
struct MadeMotion {
  Robot robot;
  CheckOptions options;
  Motion motion;
  ContactSchedule contacts;
  Demand demand;

  CheckedMotion checked() const { return {robot, options, motion, contacts, demand}; }
};

}  // namespace torquewright::hopper::check_test
