// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "io/documents/document.hpp"

namespace torquewright::cli {

/// Adds "tool" and "inputs": who wrote the document, and from which files.
void add_provenance(nlohmann::ordered_json& document, std::span<const io::Document> inputs);

/// An answer's document with its provenance, as text.
std::string result_text(nlohmann::ordered_json answer, std::span<const io::Document> inputs);

/// What whoever reads a document's text will see: it may hold less than what was written from it
/// (infinity has no number in JSON).
nlohmann::json as_read(const std::string& text);

}  // namespace torquewright::cli
