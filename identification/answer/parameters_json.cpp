// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/parameters_json.hpp"

#include <cmath>

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

/// The number under its name.
void add(const FoundNumber& number, double value, ordered_json& json) {
  json[number.name] = finite_or_null(value);
}

}  // namespace

ordered_json parameters_json(const FoundParameters& found) {
  ordered_json json = ordered_json::object();
  if (!found.channel.empty()) json["channel"] = found.channel;
  for (const FoundNumber& each : found.numbers) add(each, each.value, json);
  for (const FoundWave& wave : found.waves) {
    ordered_json entry = {{"order", wave.order}};
    add(wave.amplitude, wave.amplitude.value, entry);
    add(wave.phase_rad, wave.phase_rad.value, entry);
    json["harmonics"].push_back(std::move(entry));
  }
  if (found.proportional) json["proportional"] = *found.proportional;
  return json;
}

ordered_json standard_errors_json(const FoundParameters& found) {
  ordered_json json = ordered_json::object();
  for (const FoundNumber& each : found.numbers) add(each, each.standard_error, json);
  for (const FoundWave& wave : found.waves) {
    ordered_json entry = ordered_json::object();
    add(wave.amplitude, wave.amplitude.standard_error, entry);
    add(wave.phase_rad, wave.phase_rad.standard_error, entry);
    json["harmonics"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace torquewright::identification
