// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {

/// What a gate lets pass, and why.
struct Excuse {
  std::string_view name;
  std::string_view reason;
};

/// Fails for each name that breaks the rule and is not excused, and for each excuse without need.
inline void expect_excused(const Names& broken, const std::vector<Excuse>& excuses,
                           std::string_view rule) {
  Names left = broken;
  for (const Excuse& excuse : excuses) {
    EXPECT_EQ(left.erase(std::string(excuse.name)), 1u)
        << excuse.name << " needs no excuse any more: " << rule;
    EXPECT_FALSE(excuse.reason.empty()) << excuse.name;
  }
  for (const std::string& name : left) ADD_FAILURE() << name << ": " << rule;
}

}  // namespace torquewright::gates
