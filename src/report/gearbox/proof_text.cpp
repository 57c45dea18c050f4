// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/proof_text.hpp"

#include <fmt/format.h>

namespace torquewright::report {
namespace {

using gearbox::Verification;

std::string counts_text(const Verification& found) {
  const gearbox::proof::Counts& counts = found.counts;
  if (found.choices) {
    return fmt::format(
        "  {} choices of teeth, planets and modules, {} boxes of centre distances and shifts\n",
        *found.choices, counts.nodes);
  }
  return fmt::format(
      "  {} boxes (parts of the space of designs), cut {} times, split {} times; left at the end: "
      "{} empty, {} enumerated ({} designs), {} closed by a relaxation, {} open\n",
      counts.nodes, counts.cuts, counts.splits, counts.empty_leaves, counts.enumerated_leaves,
      counts.enumerated_points, counts.relaxation_leaves, counts.open_leaves);
}

std::string verdict_words(const Verification& found) {
  if (found.is_ended) {
    return fmt::format("ended: only {} boxes of the proof were checked.\n", found.counts.nodes);
  }
  if (found.is_accepted) {
    return fmt::format("accepted{}: {}\nChecked with {}, without the search:\n{}",
                       found.is_undecided ? ", as undecided" : "", found.claim,
                       found.choices ? "enclosures of affine arithmetic, rounded outward"
                                     : "exact fractions and intervals",
                       counts_text(found));
  }
  if (found.is_proved) {
    return "rejected: the proof is valid, but the result says more that is not true:\n";
  }
  return "rejected: the result is not proved:\n";
}

}  // namespace

std::string proof_text(const Verification& found) {
  std::string text = verdict_words(found);
  for (const std::string& fault : found.faults) text += fmt::format("  {}\n", fault);
  for (const std::string& sentence : found.checked) text += fmt::format("  {}\n", sentence);
  for (const std::string& sentence : found.unchecked) {
    text += fmt::format("Not checked: {}.\n", sentence);
  }
  return text;
}

}  // namespace torquewright::report
