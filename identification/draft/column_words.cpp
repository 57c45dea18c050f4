// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/column_words.hpp"

#include <algorithm>
#include <cctype>

#include "io/text/letter_case.hpp"
#include "io/text/unit_spelling.hpp"

namespace torquewright::identification {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_small(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_large(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Whether a new word begins between two neighbours.
bool begins_between(char before, char after) {
  return (is_small(before) && is_large(after)) || (is_letter(before) && is_digit(after));
}

std::vector<std::string> split(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i]) && !is_digit(name[i])) {
      words.emplace_back();
      continue;
    }
    if (i > 0 && begins_between(name[i - 1], name[i])) words.emplace_back();
    words.back() += name[i];
  }
  std::erase(words, "");
  return words;
}

/// A unit as people write it where the table of units has another word for it.
std::optional<io::Unit> find_written_unit(std::string_view name) {
  if (name == "C") return io::find_unit("degC");
  if (name == "radps" || name == "dps") return io::find_unit(name == "dps" ? "deg/s" : "rad/s");
  if (name.ends_with("_s")) {
    const std::string quotient = std::string(name.substr(0, name.size() - 2)) + "/s";
    if (const auto unit = io::find_unit(quotient)) return unit;
  }
  return io::find_unit(name);
}

/// "rms" of "Arms" and "A_rms".
std::string ampere_of(std::string_view unit) {
  const std::string spelt = io::unit_spelling(unit);
  return spelt == "A_rms" ? "rms" : spelt == "A_peak" ? "peak" : "";
}

std::optional<io::Unit> find_unit_or_ampere(std::string_view name) {
  return ampere_of(name).empty() ? find_written_unit(name) : io::find_unit("A");
}

/// What stands in brackets at a name's end, and the name before it; all of it where none do.
std::pair<std::string_view, std::string_view> before_brackets(std::string_view name) {
  const std::size_t open = name.find_last_of("[(");
  if (open == std::string_view::npos || open == 0) return {name, ""};
  const std::size_t close = name.find_first_of("])", open);
  if (close == std::string_view::npos) return {name, ""};
  return {name.substr(0, open), name.substr(open + 1, close - open - 1)};
}

/// The longest unit behind a sign that separates words; the name is cut before it.
std::optional<io::Unit> take_unit_at_end(std::string_view& name) {
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    if (is_letter(name[i]) || is_digit(name[i])) continue;
    const std::optional<io::Unit> unit = find_written_unit(name.substr(i + 1));
    if (!unit) continue;
    name = name.substr(0, i);
    return unit;
  }
  return std::nullopt;
}

}  // namespace

ColumnWords words_of(std::string_view column, std::string_view unit_below) {
  auto [name, in_brackets] = before_brackets(column);
  ColumnWords found;
  found.unit = find_unit_or_ampere(unit_below);
  found.ampere = ampere_of(found.unit ? unit_below : in_brackets);
  for (const std::optional<io::Unit>& each :
       {find_unit_or_ampere(in_brackets), take_unit_at_end(name)}) {
    if (!found.unit) {
      found.unit = each;
    } else if (each && !found.other && each->name != found.unit->name) {
      found.other = each;
    }
  }
  found.words = split(name);
  const bool is_current = found.unit && found.unit->dimension == io::Dimension::kCurrent;
  for (const std::string& word : found.words) {
    const std::string small = io::in_small_letters(word);
    if (is_current && (small == "rms" || small == "eff")) found.ampere = "rms";
  }
  return found;
}

}  // namespace torquewright::identification
