// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/own_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <string_view>

namespace torquewright::hopper {
namespace {

/// The element of "/joints/3/axis", and "axis"; null where the path leads to no element.
const FilePlace* place_at(std::string_view path, std::string_view list,
                          const std::vector<FilePlace>& places, std::size_t first,
                          std::string& key) {
  if (!path.starts_with(list)) return nullptr;
  path.remove_prefix(list.size());
  std::size_t index = 0;
  const auto [rest, error] = std::from_chars(path.data(), path.data() + path.size(), index);
  if (error != std::errc() || index + first >= places.size()) return nullptr;
  path.remove_prefix(static_cast<std::size_t>(rest - path.data()));
  key = path.starts_with('/') ? path.substr(1) : path;
  const FilePlace& place = places[index + first];
  return place.line == 0 ? nullptr : &place;
}

io::Fault at_own_line(const io::Fault& fault, const Imported& imported) {
  std::string key;
  const FilePlace* place = place_at(fault.path, "/joints/", imported.joint_places, 1, key);
  if (place == nullptr) place = place_at(fault.path, "/bodies/", imported.body_places, 0, key);
  if (place == nullptr) return fault;
  const std::string name = place->name.empty() ? "" : fmt::format(" name=\"{}\"", place->name);
  return {place->file, "",
          fmt::format("line {}, <{}{}>: {}{}{}", place->line, place->element, name, key,
                      key.empty() ? "" : ": ", fault.message)};
}

}  // namespace

io::SpecError at_own_lines(const io::SpecError& error, const Imported& imported) {
  std::vector<io::Fault> faults;
  for (const io::Fault& fault : error.faults()) faults.push_back(at_own_line(fault, imported));
  return io::SpecError(faults);
}

}  // namespace torquewright::hopper
