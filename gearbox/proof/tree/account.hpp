// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "gearbox/proof/reading/json_reading.hpp"
#include "gearbox/proof/reading/verdict.hpp"
#include "gearbox/proof/tree/refutation.hpp"

namespace torquewright::gearbox::proof {

/// What the parts of the checker write into.
struct Account {
  Faults faults;
  Counts counts;
  Budget budget;
  std::function<bool()> should_stop;
};

/// The checker was told to stop.
struct Stopped {};

inline void ask_whether_to_stop(const Account& account) {
  if (account.should_stop()) throw Stopped();
}

}  // namespace torquewright::gearbox::proof
