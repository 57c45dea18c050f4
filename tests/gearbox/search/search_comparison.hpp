// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/search/search.hpp"
#include "tests/oracles/gearbox_enumeration.hpp"

namespace torquewright::search_test {

/// What exhaustive enumeration says of a problem.
struct Truth {
  std::vector<oracles::Found> ranked;  ///< All feasible designs, best first.
  bool is_doubtful = false;            ///< Something hangs on rounding: nothing can be compared.
  double seconds = 0;
};
Truth enumerated(const gearbox::Problem& problem);

struct Comparison {
  std::vector<std::string> disagreements;  ///< Sentences; none: they agree.
  gearbox::SearchCounts counts;
  double search_s = 0;
  double check_s = 0;  ///< Of the independent checker.
};

/// Runs our search for the `top` best and holds it against the truth: status, designs in their
/// order, ties, objectives, that no box that holds one of them was closed without finding it, and
/// that the independent checker accepts the result as a user would receive it.
Comparison compare(const gearbox::Problem& problem, const Truth& truth,
                   optimization::RelaxationUse relaxation, std::size_t top);

}  // namespace torquewright::search_test
