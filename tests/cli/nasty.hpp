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
  bool is_refused = false;                               ///< By whoever reads it, exit code 2.
};

std::vector<Nasty> nasty_tables();  ///< CSV with a column time_s or t_s, its last one of numbers.
std::vector<Nasty> nasty_documents();  ///< JSON. What they change is refused.

struct NastyNumber {
  std::string text;
  bool is_refused = false;  ///< No finite number.
};
std::vector<NastyNumber> nasty_numbers();

/// Runs it: it ends with 0 to 3, says why where it ends with 2, and leaves as many files as are
/// named. Nothing that it prints or writes holds nan or inf (within quotes it repeats what it was
/// given), all of it is UTF-8, JSON is JSON, XML, SVG and HTML are well formed.
Outcome expect_civil(const Workplace& place, const std::vector<std::string>& command,
                     const std::string& what, std::size_t files);

/// The same, and the input is refused: exit code 2.
void expect_refused(const Workplace& place, const std::vector<std::string>& command,
                    const std::string& what, std::size_t files);

/// The same before anything is spoilt, and the input is not refused: or what is spoilt afterwards
/// would be refused for another reason.
void expect_sound(const Workplace& place, const std::vector<std::string>& command,
                  std::size_t files);

/// As `nasty` says.
void expect_judged(const Workplace& place, const std::vector<std::string>& command,
                   const std::string& what, std::size_t files, bool is_refused);

}  // namespace torquewright::cli_test
