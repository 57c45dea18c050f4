// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/program/runner.hpp"
#include "tests/fuzz/program/scene.hpp"

namespace torquewright::fuzz {

/// What one run may take. Instrumented programs need more (--patience).
struct Limits {
  double processor_s = 10.0;
  double clock_s = 120.0;  ///< On a busy machine; then it is killed.
  double resident_MB = 2048.0;
  std::size_t input_bytes = 100'000;  ///< For larger ones time and memory are not judged.

  Limits times(double factor) const;
};

/// Whether a command works for as long as it is told to, which a changed word may make long: then
/// it is ended after kShortPatience_s, and that it had not ended is no breach.
bool works_until_told(const std::vector<std::string>& arguments);
inline constexpr double kShortPatience_s = 3.0;

/// A case and all that came of it; paths are those of the program's folder.
struct Run {
  Case one;
  Outcome outcome;
  std::set<std::string> inputs, outputs;
  std::vector<std::string> changed;  ///< With "work/" or "tmp/" before them.
  std::vector<std::pair<std::string, std::string>> written;  ///< Name and bytes of changed files.
  std::size_t input_bytes = 0;
};

/// What holds for every run of the program.
struct Rule {
  const char* name;
  /// A sentence on what is wrong, or nothing.
  std::function<std::string(const Run&, const Limits&)> breach;
};

const std::vector<Rule>& rules();

struct Breach {
  std::string rule, sentence;
};

/// Of the first rule that does not hold; its name is empty where all do.
Breach breach_in(const Run& run, const Limits& limits);

}  // namespace torquewright::fuzz
