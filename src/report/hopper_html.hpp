// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/hopper_page.hpp"

namespace torquewright::report {

/// A page that needs nothing else: styles, pictures, numbers and the script of its time cursor are
/// in it, and its policy lets no other script run and asks no network. Without scripts the pictures
/// stand. What users wrote is escaped. `on_top`: sections that come before the motion, as HTML.
std::string hopper_html(const HopperPage& page, const std::string& on_top = "");

}  // namespace torquewright::report
