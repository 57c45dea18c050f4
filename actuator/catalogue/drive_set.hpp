// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "io/documents/document.hpp"

namespace torquewright::actuator {

/// An actuator and the stem of its file's name, by which it is asked for.
struct NamedActuator {
  std::string stem;
  Actuator actuator;
};

/// Actuators to choose among.
struct DriveSet {
  std::vector<NamedActuator> drives;
  std::vector<io::Document> documents;
  std::vector<std::string> left_out;  ///< Sentences: documents that could not be read.
};

/// The actuators of a folder (not those inside it), in the order of their names; documents of other
/// kinds are passed over. Throws io::SpecError where it is no folder or holds no actuator.
DriveSet drives_in(const std::filesystem::path& folder);

/// The document of a drive of the catalogue as text. Throws io::SpecError, which names the nearest,
/// where it has none of that name.
std::string catalogue_text(const std::string& stem);

/// The actuators of specs/catalogue as they were when the library was built.
DriveSet catalogue();

}  // namespace torquewright::actuator
