// SPDX-License-Identifier: Apache-2.0
#include "identification/outputs/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "actuator/region/torque_at.hpp"
#include "identification/outputs/every_output.hpp"
#include "io/refusal.hpp"
#include "io/wording.hpp"

namespace torquewright::identification {
namespace {

#define TORQUEWRIGHT_ADDRESS(name) &outputs::name,
constexpr std::array kOutputs = {TORQUEWRIGHT_EVERY_OUTPUT(TORQUEWRIGHT_ADDRESS)};
#undef TORQUEWRIGHT_ADDRESS

constexpr double kLittleCurrent = 1e-6;  ///< Of the peak: far below any saturation.

}  // namespace

std::span<const Output* const> output_library() { return kOutputs; }

const Output& output_of(std::string_view name) {
  std::vector<std::string> names;
  for (const Output* output : kOutputs) {
    if (output->name == name) return *output;
    names.emplace_back(output->name);
  }
  io::refuse("--as", fmt::format("\"{}\" is none of {}", name, io::listed(names)));
}

double torque_per_ampere_Nm_A(const actuator::Actuator& actuator) {
  actuator::Instant at;
  at.current_A = kLittleCurrent * actuator.drive.peak_current_A;
  at.winding_temperature_K = at.reference_temperature_K = actuator.motor.winding_temperature_K;
  return actuator::motor_torque_Nm(actuator, at) / at.current_A;
}

double stated(const actuator::Actuator& actuator, std::string_view effect,
              std::string_view parameter) {
  for (const actuator::Effect& each : actuator.effects) {
    if (each.kind->name != effect) continue;
    for (std::size_t i = 0; i < each.kind->parameters.size(); ++i) {
      if (each.kind->parameters[i].name == parameter) return each.values[i];
    }
  }
  return 0.0;
}

std::string others(const actuator::Actuator& actuator, std::span<const std::string_view> known) {
  std::vector<std::string> names;
  for (const actuator::Effect& each : actuator.effects) {
    if (std::find(known.begin(), known.end(), each.kind->name) == known.end()) {
      names.emplace_back(each.kind->name);
    }
  }
  return io::listed(names);
}

}  // namespace torquewright::identification
