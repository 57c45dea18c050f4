// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/documents/schema_keys.hpp"

namespace torquewright::io {

/// The JSON Schema of a kind as text, for people and their editors: other kinds that it refers to
/// stand in it. These functions require a known kind.
std::string published_schema(std::string_view kind);

/// How much of it a document to start from holds.
enum class StartKeys {
  kUsual,  ///< What one must state and what one usually states: the schema's "usually_stated".
  kAll
};

/// A document of that kind to start from, as text; empty for kinds that only programs write, and
/// where there are no `number` + 1 of them.
std::string document_to_start_from(std::string_view kind, std::size_t number = 0,
                                   StartKeys keys = StartKeys::kAll);

/// What a kind of documents is, and every key that one may have.
struct KindOfDocument {
  std::string title;
  std::string description;  ///< May be empty.
  std::vector<SchemaKey> keys;
};

KindOfDocument describe_kind(std::string_view kind);

/// Those of the keys that stand in a document, which is given as text.
std::vector<SchemaKey> keys_in(const std::string& document, const std::vector<SchemaKey>& keys);

}  // namespace torquewright::io
