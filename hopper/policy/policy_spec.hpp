// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "hopper/policy/policy_document.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {

/// A policy and the document that it stands in.
struct ReadPolicy {
  PolicyDocument policy;
  io::Document document;
};

/// Reads a `kind: policy` file. Throws io::SpecError where it is none, or its layers, inputs and
/// outputs do not fit together.
ReadPolicy read_policy(const std::filesystem::path& file);

/// The same for a document that is read already.
ReadPolicy policy_of(io::Document document);

/// Throws io::SpecError, as of that file, where a text of policy_text() could not be read again: an
/// imported network has numbers that no document holds.
void require_readable(const std::string& text, const std::string& file);

/// The document as text. Decimals are the shortest that give the same numbers again, so that what
/// is read back is the same policy to the bit. Requires a document without objection.
std::string policy_text(const PolicyDocument& document);

}  // namespace torquewright::hopper
