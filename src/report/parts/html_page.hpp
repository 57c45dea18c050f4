// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::report {

/// The stylesheet of all reports that are pages of their own.
extern const char* const kPageStyle;

/// Brings gnuplot's pictures into a page; each has ids of its own, counted over the page.
class Pictures {
 public:
  /// `option` asked for the page: messages name it.
  explicit Pictures(std::string option) : option_(std::move(option)) {}

  /// What the script draws, as an SVG element that is read out as `words`; nothing of an empty
  /// script.
  std::string draw(const std::string& script, const std::string& words);

 private:
  std::string option_;
  int count_ = 0;
};

/// An SVG document as an element of a page, its ids prefixed.
std::string inline_svg(std::string svg, const std::string& prefix);

}  // namespace torquewright::report
