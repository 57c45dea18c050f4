// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/dxf_sheet.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace torquewright::report {
namespace {

// Group codes (AutoCAD release 12, DXF reference).
enum Code {
  kKind = 0,
  kText = 1,
  kName = 2,
  kDescription = 3,
  kBigFont = 4,
  kLineType = 6,
  kStyle = 7,
  kLayer = 8,
  kVariable = 9,
  kX = 10,
  kY = 20,
  kZ = 30,
  kSize = 40,
  kWidth = 41,
  kLastHeight = 42,
  kAngle = 50,
  kColour = 62,
  kVerticesFollow = 66,
  kFlags = 70,
  kMirrored = 71,
  kAlignment = 72,
  kDashes = 73,
};

constexpr std::string_view kSolid = "CONTINUOUS";
constexpr std::string_view kStandard = "STANDARD";

}  // namespace

void DxfSheet::add(int code, std::string_view value) {
  fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
}

void DxfSheet::add(int code, int value) {
  fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
}

void DxfSheet::add(int code, double value) {
  fmt::format_to(std::back_inserter(text_), "{:>3}\n{:.9f}\n", code, value);
}

void DxfSheet::begin_section(std::string_view name) {
  add(kKind, "SECTION");
  add(kName, name);
}

void DxfSheet::end_section() { add(kKind, "ENDSEC"); }

void DxfSheet::begin_table(std::string_view name, int entries) {
  add(kKind, "TABLE");
  add(kName, name);
  add(kFlags, entries);
}

void DxfSheet::end_table() { add(kKind, "ENDTAB"); }

void DxfSheet::add_layer(std::string_view name, int colour) {
  add(kKind, "LAYER");
  add(kName, name);
  add(kFlags, 0);
  add(kColour, colour);
  add(kLineType, kSolid);
}

DxfSheet::DxfSheet(const std::vector<std::string>& layers, double text_mm) : text_mm_(text_mm) {
  begin_section("HEADER");
  add(kVariable, "$ACADVER");
  add(kText, "AC1009");
  end_section();
  begin_section("TABLES");
  begin_table("LTYPE", 1);
  add(kKind, "LTYPE");
  add(kName, kSolid);
  add(kFlags, 0);
  add(kDescription, "Solid line");
  add(kAlignment, int{'A'});
  add(kDashes, 0);
  add(kSize, 0.0);
  end_table();
  constexpr int kWhite = 7;
  begin_table("LAYER", static_cast<int>(layers.size()) + 1);
  add_layer("0", kWhite);
  int colour = 1;
  for (const std::string& layer : layers) add_layer(layer, colour++);
  end_table();
  begin_table("STYLE", 1);
  add(kKind, "STYLE");
  add(kName, kStandard);
  add(kFlags, 0);
  add(kSize, 0.0);
  add(kWidth, 1.0);
  add(kAngle, 0.0);
  add(kMirrored, 0);
  add(kLastHeight, text_mm_);
  add(kDescription, "txt");
  add(kBigFont, "");
  end_table();
  end_section();
  begin_section("BLOCKS");
  end_section();
  begin_section("ENTITIES");
}

void DxfSheet::begin_entity(std::string_view kind, std::string_view layer) {
  add(kKind, kind);
  add(kLayer, layer);
}

void DxfSheet::place(const gearbox::Point& point) {
  add(kX, point.x);
  add(kY, point.y);
  add(kZ, 0.0);
}

void DxfSheet::outline(std::string_view layer, const gearbox::Point& middle,
                       const std::vector<gearbox::Point>& points) {
  constexpr int kClosed = 1;
  begin_entity("POLYLINE", layer);
  add(kVerticesFollow, 1);
  place({0.0, 0.0});
  add(kFlags, kClosed);
  for (const gearbox::Point& point : points) {
    begin_entity("VERTEX", layer);
    place({middle.x + point.x, middle.y + point.y});
  }
  begin_entity("SEQEND", layer);
}

void DxfSheet::circle(std::string_view layer, const gearbox::Point& middle, double radius_mm) {
  if (!(radius_mm > 0.0)) return;
  begin_entity("CIRCLE", layer);
  place(middle);
  add(kSize, radius_mm);
}

void DxfSheet::point(std::string_view layer, const gearbox::Point& at) {
  begin_entity("POINT", layer);
  place(at);
}

void DxfSheet::text(std::string_view layer, const gearbox::Point& at, std::string_view words) {
  begin_entity("TEXT", layer);
  place(at);
  add(kSize, text_mm_);
  add(kText, words);
  add(kStyle, kStandard);
}

std::string DxfSheet::finished() const {
  DxfSheet whole = *this;
  whole.end_section();
  whole.add(kKind, "EOF");
  return std::move(whole.text_);
}

}  // namespace torquewright::report
