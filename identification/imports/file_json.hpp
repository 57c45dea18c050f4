// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

namespace torquewright::identification::imports {

/// A JSON file of another program. Everything throws io::SpecError with the file and the key.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& path);

  [[noreturn]] void refuse(const std::string& path, const std::string& message) const;

  /// Keys of the file that are none of these.
  void refuse_unknown(std::initializer_list<std::string_view> known) const;

  std::string text(const char* key) const;
  double number(const char* key) const;

  /// As it was written, with as few digits as tell it; true and false are 1 and 0.
  std::string number_text(const nlohmann::json& value, const std::string& path) const;

  std::string file;
  nlohmann::json root;  ///< An object.
};

}  // namespace torquewright::identification::imports
