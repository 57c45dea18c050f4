// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/file_json.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/json_text.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::identification::imports {

using nlohmann::json;

JsonFile::JsonFile(const std::filesystem::path& path) : file(path.string()) {
  const std::string text = io::read_file_bytes(path);
  root = json::parse(text, nullptr, false);
  if (!root.is_object()) refuse("", "is no JSON object");
}

void JsonFile::refuse(const std::string& path, const std::string& message) const {
  throw io::SpecError({{file, path, message}});
}

void JsonFile::refuse_unknown(std::initializer_list<std::string_view> known) const {
  std::vector<io::Fault> faults;
  for (const auto& [key, value] : root.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    faults.push_back({file, io::child_path("", key), "not understood"});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

std::string JsonFile::text(const char* key) const {
  if (!root.contains(key) || !root[key].is_string()) {
    refuse(std::string("/") + key, "missing; must be a text");
  }
  if (const auto found = io::unprintable_in(root[key].get_ref<const std::string&>())) {
    refuse(std::string("/") + key, fmt::format("holds {}; must be one line of text", *found));
  }
  return root[key];
}

double JsonFile::number(const char* key) const {
  if (!root.contains(key) || !root[key].is_number()) {
    refuse(std::string("/") + key, "missing; must be a number");
  }
  return root[key];
}

std::string JsonFile::number_text(const json& value, const std::string& path) const {
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (!value.is_number()) refuse(path, fmt::format("{} is no number", value.dump()));
  return value.dump();
}

}  // namespace torquewright::identification::imports
