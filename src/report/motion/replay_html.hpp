// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/motion/replay_page.hpp"

namespace torquewright::report {

/// The planned and the true motion under one time cursor: a page like that of a check
/// (hopper_html.hpp). A run without a row has a page without pictures and without a script.
std::string replay_html(const ReplayPage& page);

}  // namespace torquewright::report
