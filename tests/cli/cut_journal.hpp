// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {

/// A sweep of three points that writes result.json: `sweep` runs it, as often as it is called. Cut
/// short in the last line of its journal, and without its result, it ends with the same result.
inline void expect_goes_on(const Workplace& place, int exit_code,
                           const std::function<Outcome()>& sweep) {
  ASSERT_EQ(sweep().exit_code, exit_code);
  const std::string result = place.text("result.json");
  std::string journal = place.text("result.json.journal");
  EXPECT_EQ(std::count(journal.begin(), journal.end(), '\n'), 4);
  journal.resize(journal.size() - 10);
  place.write("result.json.journal", journal);
  fs::remove(place.path("result.json"));
  ASSERT_EQ(sweep().exit_code, exit_code);
  EXPECT_EQ(place.text("result.json"), result);
}

}  // namespace torquewright::cli_test
