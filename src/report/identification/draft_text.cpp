// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/draft_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace torquewright::report {
namespace {

using identification::ColumnGuess;
using identification::RigDraft;

std::string meaning_of(const ColumnGuess& guess) {
  if (!guess.quantity) return "(ignored)";
  const std::string joint = guess.joint.empty() ? "" : " of " + guess.joint;
  return fmt::format("{}{}{}", name_of(*guess.quantity), joint, guess.is_sure ? "" : " ?");
}

}  // namespace

std::string rig_draft_text(const RigDraft& draft) {
  std::size_t longest_name = 0, longest_meaning = 0;
  for (const ColumnGuess& each : draft.columns) {
    longest_name = std::max(longest_name, each.column.size());
    longest_meaning = std::max(longest_meaning, meaning_of(each).size());
  }
  std::string text;
  for (const ColumnGuess& each : draft.columns) {
    text += fmt::format("  {:<{}}  {:<{}}  {}\n", each.column, longest_name, meaning_of(each),
                        longest_meaning, each.why);
  }
  const bool is_guessed =
      std::any_of(draft.columns.begin(), draft.columns.end(),
                  [](const auto& each) { return each.quantity && !each.is_sure; });
  if (is_guessed) text += "? is a guess: see to it; the document lists it under \"assumed\".\n";
  for (const std::string& each : draft.open) text += each + "\n";
  return text;
}

}  // namespace torquewright::report
