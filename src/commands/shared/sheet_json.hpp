// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "src/commands/shared/sheet_questions.hpp"

namespace torquewright::cli {

/// What keeps an answer out of a document of kind actuator: no number, a unit of something else, a
/// number that no actuator has.
std::optional<std::string> sheet_objection(const SheetQuestion& question,
                                           const std::string& answer);

/// An actuator as its sheet prints it, and what was concluded.
struct SheetDocument {
  std::string text;         ///< A document that commands take as it is.
  std::string explanation;  ///< What was assumed and why, a line each.
};

/// A winding where the answers give one, else the curve of peak torque and no-load speed; it will
/// be in `folder`, from which it names a gearbox. Throws io::SpecError where they give neither,
/// which says what is missing.
SheetDocument sheet_document(const SheetAnswers& answers, const std::filesystem::path& folder);

}  // namespace torquewright::cli
