// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::cli {

/// Whether standard output shows colours and its user wants them: a terminal that is not "dumb",
/// and no NO_COLOR (no-color.org).
bool shows_colours();

/// A text for people whose verdicts are coloured: what passes green, what fails red, what is to be
/// looked at yellow. A word is one where it stands as a verdict does: at a line's begin or behind a
/// colon or a gap, and before a colon, a gap or the line's end.
std::string with_colours(const std::string& text);

}  // namespace torquewright::cli
