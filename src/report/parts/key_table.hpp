// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::report {

/// Every key of a kind of documents with its meaning, unit and allowed values, for a terminal.
std::string key_table_text(std::string_view kind);

/// The same of the keys that stand in a document, which is given as text; then how many more there
/// are, and what prints them.
std::string key_table_text(std::string_view kind, const std::string& document);

/// The same as the page docs/documents/KIND.md, with the document that `init` starts from.
std::string key_table_markdown(std::string_view kind);

}  // namespace torquewright::report
