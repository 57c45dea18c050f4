// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/faults/json_text.hpp"

namespace torquewright::io {

/// Receives the events of nlohmann's parser and builds the document; unlike the library's own
/// builder it sees keys that stand twice, the depth, and the place of a number that is too large.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override;
  bool number_float(double value, const std::string& numeral) override;
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
  bool key(std::string& key) override;
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& error) override;

  JsonText finish(bool complete);

 private:
  bool add(nlohmann::json value);
  bool open(nlohmann::json container);
  bool close();
  nlohmann::json* place(nlohmann::json value);
  std::string path() const;
  void report(std::string path, std::string message);

  std::string_view text_;
  const std::string& file_;
  nlohmann::json root_;
  std::vector<nlohmann::json*> open_;  ///< The containers around the present value.
  std::vector<std::string> keys_;      ///< The present key in each; unused for lists.
  std::vector<Fault> faults_;
};

}  // namespace torquewright::io
