// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// Whether the file begins as one that gzip compressed (RFC 1952).
bool begins_as_gzip(std::string_view first_bytes);

/// Returns what gzip compressed in the file of that name, one member or several behind one another,
/// as they come when files are joined. Reading throws SpecError where it is damaged or ends early.
std::unique_ptr<ByteSource> gzip_bytes(std::unique_ptr<ByteSource> compressed, std::string file);

}  // namespace torquewright::io
