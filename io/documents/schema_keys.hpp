// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace torquewright::io {

/// A key that a document may have, as its schema says.
struct SchemaKey {
  std::string pointer;  ///< /motor/resistance_ohm; * for each entry of a list, or for any key.
  std::string allowed;  ///< In words: "a number from 1e-05 to 1000 or an object".
  std::string unit;     ///< Empty: it has none.
  std::string meaning;
  bool is_required;  ///< Where the object that it belongs to stands at all.
};

/// Every key, in the schema's order. A key that stands in several alternatives is there once.
std::vector<SchemaKey> keys_of(const nlohmann::ordered_json& schema);

}  // namespace torquewright::io
