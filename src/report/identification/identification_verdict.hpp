// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/answer/identify.hpp"

namespace torquewright::report {

/// The verdict in plain words, as the equations' own verdicts come to it: what is missing, what is
/// not told apart, what is left, or why nothing can be said.
std::string verdict_sentence(const identification::Identification& found, bool select);

/// Effects that options left out, as a sentence; empty where all were asked.
std::string not_asked_sentence(const identification::Identification& found);

}  // namespace torquewright::report
