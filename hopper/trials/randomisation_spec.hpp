// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/trials/randomisation.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {

struct ReadRandomisation {
  Randomisation randomisation;
  io::Document document;
};

/// Reads a document of kind `randomisation`. Throws io::SpecError with all its faults: what the
/// schema refuses, and ranges upside down. Names are judged by require_fits.
ReadRandomisation read_randomisation(const std::filesystem::path& file);
/// Reads a document that is parsed already.
ReadRandomisation randomisation_of(io::Document document);

}  // namespace torquewright::hopper
