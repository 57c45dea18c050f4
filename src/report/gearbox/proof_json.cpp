// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/proof_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

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

}  // namespace

nlohmann::ordered_json proof_json(const gearbox::Verification& found) {
  nlohmann::ordered_json report{
      {"kind", "verification_report"}, {"version", 1},
      {"accepted", found.is_accepted}, {"undecided", found.is_undecided},
      {"ended", found.is_ended},       {"proved", found.is_proved},
      {"claim", found.claim},          {"counts", counts_json(found.counts)},
      {"checked", found.checked},      {"unchecked", found.unchecked},
      {"faults", found.faults}};
  if (found.choices) report["counts"]["choices"] = *found.choices;
  return report;
}

}  // namespace torquewright::report
