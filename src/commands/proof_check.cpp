// SPDX-License-Identifier: Apache-2.0
#include "src/commands/proof_check.hpp"

#include <fmt/format.h>

#include "gearbox/verification/verification_json.hpp"

namespace torquewright::cli {
namespace {

using gearbox::Verification;

std::string counts_text(const gearbox::proof::Counts& counts) {
  return fmt::format(
      "  {} boxes, {} cuts, {} splits; leaves: {} empty, {} enumerated ({} points), {} by "
      "relaxation, "
      "{} open\n",
      counts.nodes, counts.cuts, counts.splits, counts.empty_leaves, counts.enumerated_leaves,
      counts.enumerated_points, counts.relaxation_leaves, counts.open_leaves);
}

std::string verdict_text(const Verification& found) {
  if (found.is_accepted) {
    return fmt::format(
        "accepted{}: {}\nChecked with exact fractions and intervals, without the "
        "search:\n{}",
        found.is_undecided ? ", as undecided" : "", found.claim, counts_text(found.counts));
  }
  if (found.is_proved) {
    return "rejected: the proof is valid, but what the result says beside it is not so:\n";
  }
  return "rejected: the result is not proved:\n";
}

nlohmann::ordered_json counts_json(const gearbox::proof::Counts& counts) {
  return {{"nodes", counts.nodes},
          {"cuts", counts.cuts},
          {"splits", counts.splits},
          {"empty_leaves", counts.empty_leaves},
          {"enumerated_leaves", counts.enumerated_leaves},
          {"enumerated_points", counts.enumerated_points},
          {"relaxation_leaves", counts.relaxation_leaves},
          {"open_leaves", counts.open_leaves}};
}

nlohmann::ordered_json verdict_json(const Verification& found) {
  return {{"accepted", found.is_accepted},       {"undecided", found.is_undecided},
          {"proved", found.is_proved},           {"claim", found.claim},
          {"counts", counts_json(found.counts)}, {"checked", found.checked},
          {"unchecked", found.unchecked},        {"faults", found.faults}};
}

}  // namespace

ProofCheck check_proof(const gearbox::Problem& problem, const nlohmann::json& result) {
  const Verification found = gearbox::verify(problem, result);
  std::string text = verdict_text(found);
  for (const std::string& fault : found.faults) text += fmt::format("  {}\n", fault);
  for (const std::string& sentence : found.checked) text += fmt::format("  {}\n", sentence);
  for (const std::string& sentence : found.unchecked) {
    text += fmt::format("Not checked: {}.\n", sentence);
  }
  return {found.is_accepted, found.is_undecided, text, verdict_json(found)};
}

}  // namespace torquewright::cli
