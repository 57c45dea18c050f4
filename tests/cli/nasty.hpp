// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {

/// A way to spoil a good file.
struct Nasty {
  const char* what;
  std::function<std::string(const std::string&)> spoil;  ///< A good file's text.
};

std::vector<Nasty> nasty_tables();     ///< CSV with a column time_s.
std::vector<Nasty> nasty_documents();  ///< JSON.
std::vector<std::string> nasty_numbers();

/// Runs it: it ends with 0 to 3, says why where it ends with 2, writes no nan or inf, and leaves as
/// many files as are named.
void expect_civil(const Workplace& place, const std::vector<std::string>& command,
                  const std::string& what, std::size_t files);

}  // namespace torquewright::cli_test
