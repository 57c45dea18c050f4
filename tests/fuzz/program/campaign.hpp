// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "tests/fuzz/program/case.hpp"
#include "tests/fuzz/program/rules.hpp"

namespace torquewright::fuzz {

struct Plan {
  std::filesystem::path program;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;         ///< Number of the first case.
  std::uint64_t runs = 0;          ///< 0: until the time is over.
  double seconds = 0.0;            ///< 0: until the runs are done.
  double patience = 1.0;           ///< Times the limits.
  std::filesystem::path findings;  ///< Folder into which they are written; empty: none.
  int most_findings = 20;
  std::filesystem::path copies;      ///< Program that runs are copies of; empty: each is started.
  std::vector<std::string> without;  ///< Command lines that begin so are left out.
};

/// Runs the cases that are kept (tests/fuzz/corpus/program), then drawn ones. Prints every finding
/// with how to repeat it, and counts. The number of findings.
int run_campaign(const Plan& plan);

/// Runs one case that stands in a file, and prints what it breaks.
int repeat_case(const Plan& plan, const std::filesystem::path& file);

}  // namespace torquewright::fuzz
