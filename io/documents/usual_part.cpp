// SPDX-License-Identifier: Apache-2.0
#include "io/documents/usual_part.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace torquewright::io {
namespace {

using nlohmann::ordered_json;
using Steps = std::vector<std::string>;

constexpr const char* kAny = "*";

Steps steps_of(const std::string& pointer) {
  Steps steps;
  std::istringstream stream(pointer.substr(std::min<std::size_t>(1, pointer.size())));
  for (std::string step; std::getline(stream, step, '/');) steps.push_back(step);
  return steps;
}

/// The steps that are left below a key, of those that lead through it.
std::vector<Steps> below(const std::vector<Steps>& all, const std::string& key) {
  std::vector<Steps> rest;
  for (const Steps& steps : all) {
    if (steps.front() == key || steps.front() == kAny)
      rest.emplace_back(steps.begin() + 1, steps.end());
  }
  return rest;
}

ordered_json named_part(const ordered_json& value, const std::vector<Steps>& named) {
  const bool is_named =
      std::any_of(named.begin(), named.end(), [](const Steps& steps) { return steps.empty(); });
  if (is_named || !value.is_structured()) return is_named ? value : ordered_json();
  ordered_json part = value.is_array() ? ordered_json::array() : ordered_json::object();
  for (const auto& [key, child] : value.items()) {
    ordered_json kept = named_part(child, below(named, key));
    if (kept.is_null()) continue;
    if (value.is_array()) {
      part.push_back(std::move(kept));
    } else {
      part[key] = std::move(kept);
    }
  }
  return part.empty() ? ordered_json() : part;
}

bool stands_in(const ordered_json& value, const Steps& steps, std::size_t at) {
  if (at == steps.size()) return true;
  if (!value.is_structured()) return false;
  if (steps[at] == kAny) {
    return std::any_of(value.begin(), value.end(),
                       [&](const ordered_json& child) { return stands_in(child, steps, at + 1); });
  }
  return value.is_object() && value.contains(steps[at]) &&
         stands_in(value[steps[at]], steps, at + 1);
}

/// What is not there any more is not assumed either.
void keep_assumed(const ordered_json& document, ordered_json& part) {
  if (!document.contains("assumed")) return;
  ordered_json assumed = ordered_json::array();
  for (const ordered_json& pointer : document["assumed"]) {
    const ordered_json::json_pointer place(pointer.get<std::string>());
    if (part.contains(place)) assumed.push_back(pointer);
  }
  if (!assumed.empty()) part["assumed"] = std::move(assumed);
}

}  // namespace

ordered_json usual_part(const ordered_json& document, const std::vector<std::string>& pointers) {
  std::vector<Steps> named{{"kind"}, {"version"}};
  for (const std::string& pointer : pointers) named.push_back(steps_of(pointer));
  ordered_json part = named_part(document, named);
  keep_assumed(document, part);
  return part;
}

bool stands_in(const ordered_json& document, const std::string& pointer) {
  return stands_in(document, steps_of(pointer), 0);
}

}  // namespace torquewright::io
