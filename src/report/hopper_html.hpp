// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/hopper_page.hpp"

namespace torquewright::report {

/// A page that needs nothing else: styles, pictures, numbers and the script of its time cursor are
/// in it, and its policy lets no other script run and asks no network. Without scripts the pictures
/// stand. What users wrote is escaped.
std::string hopper_html(const HopperPage& page);

}  // namespace torquewright::report
