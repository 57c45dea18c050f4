// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/documented_number_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper::calibration {
namespace {

using nlohmann::json;

std::vector<std::string> parts_of(json::json_pointer pointer) {
  std::vector<std::string> parts;
  for (; !pointer.empty(); pointer.pop_back()) parts.insert(parts.begin(), pointer.back());
  return parts;
}

std::string owner_of(const std::vector<std::string>& parts, const json& root) {
  if (parts.size() < 3 || (parts[0] != "bodies" && parts[0] != "joints")) return "";
  return root.at(json::json_pointer("/" + parts[0] + "/" + parts[1]))["name"];
}

}  // namespace

DocumentedNumber documented_number(const std::string& pointer, const io::Document& document,
                                   const char* option) {
  json::json_pointer place;
  try {
    place = json::json_pointer(pointer);
    (void)document.root.contains(place);
  } catch (const json::exception&) {
    io::refuse(option,
               fmt::format("\"{}\" is no JSON pointer, such as /bodies/0/mass_kg", pointer));
  }
  if (!document.root.contains(place) || !document.root[place].is_number()) {
    io::refuse(option, fmt::format("no number stands at {} of {}", pointer, document.file));
  }
  const std::vector<std::string> parts = parts_of(place);
  return {parts, owner_of(parts, document.root), document.root[place]};
}

}  // namespace torquewright::hopper::calibration
