// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/library_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "robot/mechanisms/every_mechanism.hpp"

namespace torquewright::hopper {
namespace {

#define TORQUEWRIGHT_ADDRESS(name) &mechanisms::name,
constexpr std::array kTypes{TORQUEWRIGHT_EVERY_MECHANISM(TORQUEWRIGHT_ADDRESS)};
#undef TORQUEWRIGHT_ADDRESS

bool is_among(std::span<const std::string_view> keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool knows(const MechanismType& type, std::string_view key) {
  return is_among(type.needs, key) || is_among(type.may_state, key);
}

}  // namespace

std::span<const MechanismType* const> mechanism_types() { return kTypes; }

bool has_right_keys(const MechanismType& type, const MechanismKeys& keys) {
  const std::size_t before = keys.faults.size();
  for (const auto& [key, value] : keys.keys.items()) {
    if (knows(type, key)) continue;
    for (const MechanismType* other : kTypes) {
      if (!knows(*other, key)) continue;
      keys.report("/" + key, fmt::format("is for {} mechanisms", other->name));
      break;
    }
  }
  for (const std::string_view key : type.needs) {
    if (!keys.keys.contains(key)) keys.report(fmt::format("/{}", key), "missing");
  }
  return keys.faults.size() == before;
}

nlohmann::ordered_json mechanism_keys(const Mechanism& mechanism) {
  const auto type = std::find_if(kTypes.begin(), kTypes.end(), [&](const MechanismType* each) {
    return each->name == mechanism.type();
  });
  return (*type)->write(mechanism);
}

}  // namespace torquewright::hopper
