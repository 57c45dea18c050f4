// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "identification/imports/every_importer.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

#define TORQUEWRIGHT_ADDRESS(name) &imports::name,
constexpr std::array kAll = {TORQUEWRIGHT_EVERY_IMPORTER(TORQUEWRIGHT_ADDRESS)};
#undef TORQUEWRIGHT_ADDRESS

}  // namespace

std::span<const Importer* const> importer_library() { return kAll; }

const Importer& importer_of(std::string_view name) {
  std::vector<std::string> names;
  for (const Importer* importer : kAll) {
    if (importer->name == name) return *importer;
    names.emplace_back(importer->name);
  }
  const auto near = io::nearest(std::string(name), names);
  io::refuse("format", fmt::format("\"{}\" is not a format; {}", name,
                                   near ? fmt::format("did you mean \"{}\"?", *near)
                                        : "there are " + io::listed(names)));
}

}  // namespace torquewright::identification
