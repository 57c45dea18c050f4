// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <vector>

#include "identification/outputs/every_output.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

#define TORQUEWRIGHT_ADDRESS(name) &outputs::name,
constexpr std::array kOutputs = {TORQUEWRIGHT_EVERY_OUTPUT(TORQUEWRIGHT_ADDRESS)};
#undef TORQUEWRIGHT_ADDRESS

}  // namespace

std::span<const Output* const> output_library() { return kOutputs; }

const Output& output_of(std::string_view name) {
  std::vector<std::string> names;
  for (const Output* output : kOutputs) {
    if (output->name == name) return *output;
    names.emplace_back(output->name);
  }
  io::refuse("--as", fmt::format("\"{}\" is not one of {}", name, io::listed(names)));
}

}  // namespace torquewright::identification
