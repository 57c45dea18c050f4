// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

namespace torquewright::identification::imports {

/// A JSON file of another program. All members throw io::SpecError with the file and the key.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& path);

  [[noreturn]] void refuse(const std::string& path, const std::string& message) const;

  /// Refuses keys of the file that are not among these.
  void refuse_unknown(std::initializer_list<std::string_view> known) const;

  std::string text(const char* key) const;
  double number(const char* key) const;

  /// Returns a number as text, with as few digits as tell it; true and false are 1 and 0.
  std::string number_text(const nlohmann::json& value, const std::string& path) const;

  std::string file;
  nlohmann::json root;  ///< The file's content, an object.
};

}  // namespace torquewright::identification::imports
