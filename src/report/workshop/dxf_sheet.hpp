// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::report {

/// The text of a DXF file of release 12, which every program reads: pairs of a group code and a
/// value, a line each. Lengths in millimetres, to a picometre.
class DxfSheet {
 public:
  /// Layers get the colours 1, 2, 3 ... `text_mm` is the height of its letters.
  DxfSheet(const std::vector<std::string>& layers, double text_mm);

  void outline(std::string_view layer, const gearbox::Point& middle,
               const std::vector<gearbox::Point>& points);
  /// Nothing where the radius is not positive.
  void circle(std::string_view layer, const gearbox::Point& middle, double radius_mm);
  void point(std::string_view layer, const gearbox::Point& place);
  void text(std::string_view layer, const gearbox::Point& place, std::string_view words);

  /// The whole file.
  std::string finished() const;

 private:
  void add(int code, std::string_view value);
  void add(int code, int value);
  void add(int code, double value);
  void begin_section(std::string_view name);
  void end_section();
  void begin_table(std::string_view name, int entries);
  void end_table();
  void add_layer(std::string_view name, int colour);
  void begin_entity(std::string_view kind, std::string_view layer);
  void place(const gearbox::Point& point);

  double text_mm_;
  std::string text_;
};

}  // namespace torquewright::report
