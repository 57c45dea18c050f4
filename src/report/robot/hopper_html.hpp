// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/robot/hopper_page.hpp"

namespace torquewright::report {

/// What stands around the motion on a page.
struct PageHead {
  std::string title;     ///< Of the window.
  std::string sections;  ///< As HTML, before the motion.
  std::string behind{};  ///< As HTML, behind all else.
};
/// The verdict and the violations.
PageHead checked_head(const HopperPage& page);

/// A page that needs nothing else: styles, pictures, numbers and the script of its time cursor are
/// in it, and its policy lets no other script run and asks no network. Without scripts the pictures
/// stand. What users wrote is escaped.
std::string hopper_html(const HopperPage& page, const PageHead& head);
std::string hopper_html(const HopperPage& page);

}  // namespace torquewright::report
