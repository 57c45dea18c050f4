// SPDX-License-Identifier: Apache-2.0
#include "robot/xml/vocabulary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace torquewright::hopper {
namespace {

bool contains_word(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != std::string_view::npos;
       at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool starts = at == 0 || list[at - 1] == ' ';
    if (starts && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

/// "0", "0 0", "false", "none": as if it were absent.
bool says_nothing(const std::string& value) {
  if (value == "false" || value == "none" || value == "auto") return true;
  return value.find_first_not_of("0. ") == std::string::npos;
}

/// By its name, or by that of what holds it.
std::string place_of(const Element& element, const Element& holder) {
  const std::string name = attribute(element, "name");
  if (!name.empty()) return name;
  const std::string around = attribute(holder, "name");
  return around.empty() ? fmt::format("line {}", element.line) : around;
}

}  // namespace

std::string listed(std::vector<std::string> places) {
  constexpr std::size_t kMost = 12;
  if (places.size() <= kMost) return fmt::format("{}", fmt::join(places, ", "));
  const std::size_t more = places.size() - kMost;
  places.resize(kMost);
  return fmt::format("{} and {} more", fmt::join(places, ", "), more);
}

namespace {

/// Each with how often it stands there.
std::string counted(const std::map<std::string, int>& words) {
  std::vector<std::string> list;
  for (const auto& [word, times] : words) {
    list.push_back(times == 1 ? word : fmt::format("{} ({} times)", word, times));
  }
  return listed(std::move(list));
}

}  // namespace

const Words* Vocabulary::find(std::string_view element, Words::Kind kind,
                              std::string_view name) const {
  const auto found = std::find_if(words_.begin(), words_.end(), [&](const Words& words) {
    return words.kind == kind && contains_word(words.elements, element) &&
           contains_word(words.names, name);
  });
  return found == words_.end() ? nullptr : &*found;
}

void Vocabulary::check_word(const Element& element, Words::Kind kind, const std::string& name,
                            const Element& place) {
  const Words* words = find(element.name, kind, name);
  const bool is_element = kind == Words::Kind::kChildren;
  const std::string word =
      is_element ? fmt::format("<{}>", name) : fmt::format("{} of <{}>", name, element.name);
  const char* sort = is_element ? "element" : "attribute";
  if (words == nullptr && unlisted_ == Unlisted::kIgnored) {
    ++ignored_[word];
  } else if (words == nullptr) {
    refuse(
        place, name, word,
        fmt::format("the {} {} is not known here; it might change mass or kinematics", sort, word));
  } else if (words->meaning == Meaning::kRefused) {
    refuse(place, name, word, fmt::format("the {} {} is not read; {}", sort, word, words->advice));
  } else if (words->meaning == Meaning::kNeutral) {
    neutral_.insert(word);
  } else if (words->meaning == Meaning::kForce) {
    const std::string where = place_of(place, element);
    if (places_.emplace(word, where).second) forces_[word].push_back(where);
  }
}

void Vocabulary::refuse(const Element& place, const std::string& name, const std::string& word,
                        const std::string& why) {
  if (left_.count(name) > 0) {
    ++found_left_[name][word];
  } else {
    faults_->report(place, fmt::format("{} (--ignore {} leaves it behind)", why, name));
  }
}

void Vocabulary::check_attributes(const Element& element) {
  for (const auto& [name, value] : element.attributes) {
    if (name.starts_with("xmlns")) continue;
    const Words* words = find(element.name, Words::Kind::kAttributes, name);
    if (words != nullptr && words->meaning != Meaning::kRead && says_nothing(value)) continue;
    check_word(element, Words::Kind::kAttributes, name, element);
  }
}

void Vocabulary::check(const Element& element) {
  check_attributes(element);
  for (const Element& held : element.children) {
    const bool is_empty =
        std::all_of(held.attributes.begin(), held.attributes.end(), [&](const auto& next) {
          const Words* known = find(held.name, Words::Kind::kAttributes, next.first);
          return says_nothing(next.second) ||
                 (known != nullptr && known->meaning == Meaning::kRead);
        });
    const Words* words = find(element.name, Words::Kind::kChildren, held.name);
    if (words != nullptr && words->meaning == Meaning::kForce && is_empty) continue;
    check_word(element, Words::Kind::kChildren, held.name, held);
  }
}

std::vector<std::string> Vocabulary::notes_of_left() const {
  std::vector<std::string> notes;
  for (const std::string& name : left_) {
    const auto found = found_left_.find(name);
    if (found == found_left_.end()) {
      notes.push_back(fmt::format("--ignore {}: nothing that is refused is called so", name));
    } else {
      notes.push_back(fmt::format("left behind by --ignore {}: {}", name, counted(found->second)));
    }
  }
  return notes;
}

std::vector<std::string> Vocabulary::notes() const {
  std::vector<std::string> notes = notes_of_left();
  for (const auto& [what, places] : forces_) {
    notes.push_back(
        fmt::format("{} is a force that a robot document does not hold, so that drives "
                    "are charged with it: {}",
                    what, listed(places)));
  }
  if (!ignored_.empty()) {
    notes.push_back(
        fmt::format("left behind, for the format does not define it and its readers skip it: {}",
                    counted(ignored_)));
  }
  if (!neutral_.empty()) {
    notes.push_back(fmt::format("left behind, for it changes neither mass nor kinematics: {}",
                                fmt::join(neutral_, ", ")));
  }
  return notes;
}

}  // namespace torquewright::hopper
