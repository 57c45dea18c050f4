// SPDX-License-Identifier: Apache-2.0
#include "io/files/named_files.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A gearbox, a mechanism's drives and its gears' strength; what a result, or a refined actuator,
/// was made from; the fitted robot and the candidate of a report; the schema for editors.
constexpr std::array<std::string_view, 7> kKeysOfFiles = {"file",  "actuators", "strength", "path",
                                                          "robot", "candidate", "$schema"};

/// Keeps the texts under those keys, also those of a list. No tree of values is made.
class NamesInDocument : public json::json_sax_t {
 public:
  std::vector<std::string> names;

  bool key(string_t& key) override {
    is_of_file_ = std::find(kKeysOfFiles.begin(), kKeysOfFiles.end(), key) != kKeysOfFiles.end();
    return true;
  }
  bool string(string_t& text) override {
    if (is_of_file_ && !text.empty()) names.push_back(text);
    return true;
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

 private:
  bool is_of_file_ = false;
};

}  // namespace

std::vector<fs::path> files_named_in(std::string_view text, const fs::path& document) {
  NamesInDocument found;
  json::sax_parse(text, &found);
  std::vector<fs::path> files;
  for (const std::string& name : found.names) {
    files.push_back(document.parent_path() / name);
    files.emplace_back(name);
  }
  return files;
}

}  // namespace torquewright::io
