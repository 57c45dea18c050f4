// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/minimise.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace torquewright::fuzz {
namespace {

using nlohmann::json;

class Minimiser {
 public:
  Minimiser(Case one, const StillBreaks& still_breaks, int most_trials)
      : one_(std::move(one)), still_breaks_(still_breaks), trials_left_(most_trials) {}

  Case smallest() {
    drop_things();
    drop_words();
    for (auto& [name, thing] : Case(one_).things) {
      drop_document_parts(name);
      drop_pieces(name);
    }
    return one_;
  }

 private:
  bool takes(const Case& smaller) {
    if (trials_left_-- <= 0 || !still_breaks_(smaller)) return false;
    one_ = smaller;
    return true;
  }

  void drop_things() {
    for (const auto& [name, thing] : Case(one_).things) {
      Case smaller = one_;
      smaller.things.erase(name);
      takes(smaller);
    }
  }

  /// Two words at a time first: an option and its value.
  void drop_words() {
    for (const std::size_t count : {2, 1}) {
      for (std::size_t i = 0; i + count <= one_.arguments.size();) {
        Case smaller = one_;
        const auto start = smaller.arguments.begin() + static_cast<long>(i);
        smaller.arguments.erase(start, start + static_cast<long>(count));
        if (!takes(smaller)) ++i;
      }
    }
  }

  void drop_pieces(const std::string& name) {
    std::size_t size = one_.things[name].content.size() / 2;
    for (; size > 0 && trials_left_ > 0; size /= 2) {
      for (std::size_t at = 0; at + size <= one_.things[name].content.size();) {
        Case smaller = one_;
        smaller.things[name].content.erase(at, size);
        if (!takes(smaller)) at += size;
        if (trials_left_ <= 0) return;
      }
    }
  }

  /// Members and elements, the outermost first.
  void drop_document_parts(const std::string& name) {
    const json document = json::parse(one_.things[name].content, nullptr, false);
    if (document.is_discarded()) return;
    std::vector<json::json_pointer> places;
    const json flat = document.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      for (json::json_pointer place(pointer); !place.empty(); place = place.parent_pointer()) {
        places.push_back(place);
      }
    }
    std::sort(places.begin(), places.end(), [](const auto& one, const auto& other) {
      return one.to_string().size() < other.to_string().size();
    });
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const json::json_pointer& place : places) drop_part(name, place);
  }

  void drop_part(const std::string& name, const json::json_pointer& place) {
    Case smaller = one_;
    json document = json::parse(one_.things[name].content, nullptr, false);
    if (document.is_discarded() || !document.contains(place)) return;
    json& parent = document[place.parent_pointer()];
    if (parent.is_object()) parent.erase(place.back());
    if (parent.is_array()) parent.erase(std::stoul(place.back()));
    smaller.things[name].content = document.dump(1, ' ', false, json::error_handler_t::replace);
    takes(smaller);
  }

  Case one_;
  const StillBreaks& still_breaks_;
  int trials_left_;
};

}  // namespace

Case minimised(Case one, const StillBreaks& still_breaks, int most_trials) {
  return Minimiser(std::move(one), still_breaks, most_trials).smallest();
}

}  // namespace torquewright::fuzz
