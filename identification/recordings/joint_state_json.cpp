// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/joint_state_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace torquewright::identification {
namespace {

using nlohmann::json;

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// The one of the names that the object has; null without.
json any_of(const json& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (object.is_object() && object.contains(name)) return object[name];
  }
  return nullptr;
}

/// "sec" and "nanosec" in ROS 2, "secs" and "nsecs" or "nsec" elsewhere.
std::int64_t stamp_ns(const json& message) {
  const json stamp = any_of(any_of(message, {"header"}), {"stamp"});
  const json seconds = any_of(stamp, {"sec", "secs"});
  const json rest = any_of(stamp, {"nanosec", "nsec", "nsecs"});
  if (!seconds.is_number_integer() || !rest.is_number_integer()) return 0;
  return seconds.get<std::int64_t>() * kSecond_ns + rest.get<std::int64_t>();
}

/// JSON has no word for what is no number: null stands for it.
bool take_numbers(const json& message, const char* name, std::vector<double>& values) {
  values.clear();
  const json list = any_of(message, {name});
  if (list.is_null()) return true;
  if (!list.is_array()) return false;
  for (const json& each : list) {
    if (!each.is_number() && !each.is_null()) return false;
    values.push_back(each.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                    : each.get<double>());
  }
  return true;
}

bool take_names(const json& message, std::vector<std::string>& names) {
  names.clear();
  const json list = any_of(message, {"name"});
  if (!list.is_array()) return false;
  for (const json& each : list) {
    if (!each.is_string()) return false;
    names.push_back(each);
  }
  return true;
}

}  // namespace

std::string read_json_joint_state(std::string_view bytes, JointState& state) {
  const json message = json::parse(bytes, nullptr, false);
  if (!message.is_object()) return "is no JSON object";
  if (!take_names(message, state.names)) return "has no \"name\" that is a list of texts";
  state.stamp_ns = stamp_ns(message);
  const struct {
    const char* name;
    std::vector<double>& values;
  } lists[] = {
      {"position", state.position}, {"velocity", state.velocity}, {"effort", state.effort}};
  for (const auto& [name, values] : lists) {
    if (!take_numbers(message, name, values)) {
      return fmt::format("has a \"{}\" that is no list of numbers", name);
    }
  }
  return "";
}

}  // namespace torquewright::identification
