// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/draft/rig_draft.hpp"

namespace torquewright::report {

/// What each column of a log is taken for and by what, a line each, and what the log does not say.
std::string rig_draft_text(const identification::RigDraft& draft);

}  // namespace torquewright::report
