// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/gear_dxf.hpp"

#include <dxflib/dl_dxf.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <numbers>

#include "gearbox/teeth/tooth_outline.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/file_bytes.hpp"

namespace torquewright::report {
namespace {

using gearbox::Point;

constexpr double kChord_mm = 2e-4;
constexpr double kText_mm = 2.5;
constexpr const char* kPitchLayer = "PITCH";
constexpr const char* kDataLayer = "DATA";

std::string layer_name(const DrawnGear& gear) {
  std::string name = gear.id;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return name;
}

double outer_radius_mm(const DrawingLayout& layout, const DrawnGear& gear) {
  return gear.internal ? 0.5 * blank_diameter_mm(layout, gear) : gear.module_mm * gear.tip_radius;
}

/// All points of a gear's outline about the origin, in mm, the first not repeated.
std::vector<Point> outline_mm(const DrawnGear& gear) {
  std::vector<Point> pitch =
      gearbox::sample(gearbox::pitch_curves(*gear.form), kChord_mm / gear.module_mm);
  pitch.pop_back();  // The next pitch begins there.
  std::vector<Point> points;
  for (std::int64_t tooth = 0; tooth < gear.teeth; ++tooth) {
    const double angle_rad =
        2.0 * std::numbers::pi * static_cast<double>(tooth) / static_cast<double>(gear.teeth);
    for (const Point& point : pitch) {
      const Point turned = gearbox::turned(point, angle_rad);
      points.push_back({gear.module_mm * turned.x, gear.module_mm * turned.y});
    }
  }
  return points;
}

/// A file that stands on no disk.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("dxf", MFD_CLOEXEC)) {
    if (descriptor_ < 0) io::refuse("--dxf", "the system gives no memory to write a file into");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// Writes one file; the library knows no other way than by its name.
class DxfSheet {
 public:
  explicit DxfSheet(const std::string& file) : writer_(dxf_.out(file.c_str(), DL_Codes::AC1009)) {}

  void begin(const std::vector<std::string>& layers) {
    dxf_.writeHeader(*writer_);
    writer_->sectionEnd();
    writer_->sectionTables();
    dxf_.writeVPort(*writer_);
    writer_->tableLinetypes(1);
    dxf_.writeLinetype(*writer_, DL_LinetypeData("CONTINUOUS", "Continuous", 0, 0, 0.0));
    writer_->tableEnd();
    writer_->tableLayers(static_cast<int>(layers.size()) + 1);
    dxf_.writeLayer(*writer_, DL_LayerData("0", 0), DL_Attributes("", 7, -1, "CONTINUOUS", 1.0));
    int colour = 1;
    for (const std::string& layer : layers) {
      dxf_.writeLayer(*writer_, DL_LayerData(layer, 0),
                      DL_Attributes("", colour++, -1, "CONTINUOUS", 1.0));
    }
    writer_->tableEnd();
    writer_->tableStyle(1);
    dxf_.writeStyle(*writer_, DL_StyleData("STANDARD", 0, 0.0, 1.0, 0.0, 0, kText_mm, "txt", ""));
    writer_->tableEnd();
    writer_->sectionEnd();
    writer_->sectionBlocks();
    writer_->sectionEnd();
    writer_->sectionEntities();
  }

  void end() {
    writer_->sectionEnd();
    writer_->dxfEOF();
    writer_->close();
  }

  void outline(const std::string& layer, const Point& middle, const std::vector<Point>& points) {
    constexpr int kClosed = 1;
    dxf_.writePolyline(*writer_, DL_PolylineData(static_cast<int>(points.size()), 0, 0, kClosed),
                       attributes(layer));
    for (const Point& point : points) {
      dxf_.writeVertex(*writer_, DL_VertexData(middle.x + point.x, middle.y + point.y));
    }
    dxf_.writePolylineEnd(*writer_);
  }

  void circle(const std::string& layer, const Point& middle, double radius_mm) {
    if (!(radius_mm > 0.0)) return;
    dxf_.writeCircle(*writer_, DL_CircleData(middle.x, middle.y, 0.0, radius_mm),
                     attributes(layer));
  }

  void point(const std::string& layer, const Point& place) {
    dxf_.writePoint(*writer_, DL_PointData(place.x, place.y, 0.0), attributes(layer));
  }

  void text(const Point& place, const std::string& words) {
    dxf_.writeText(*writer_,
                   DL_TextData(place.x, place.y, 0.0, place.x, place.y, 0.0, kText_mm, 1.0, 0, 0, 0,
                               words, "STANDARD", 0.0),
                   attributes(kDataLayer));
  }

 private:
  static DL_Attributes attributes(const std::string& layer) {
    return {layer, 256, -1, "BYLAYER", 1.0};
  }

  DL_Dxf dxf_;
  std::unique_ptr<DL_WriterA> writer_;
};

void draw_gear(const DrawingLayout& layout, const DrawnGear& gear, const Point& middle,
               DxfSheet& sheet) {
  const std::string layer = layer_name(gear);
  if (gear.form) {
    sheet.outline(layer, middle, outline_mm(gear));
  } else {
    sheet.circle(layer, middle, gear.module_mm * gear.tip_radius);
    sheet.circle(layer, middle, gear.module_mm * gear.root_radius);
  }
  sheet.point(layer, middle);
  if (gear.internal) sheet.circle(layer, middle, outer_radius_mm(layout, gear));
  if (gear.symbol == "S")
    sheet.circle(layer, middle, 0.5 * layout.drawing.hollow_shaft_diameter_mm);
  sheet.circle(kPitchLayer, middle, 0.5 * gear.module_mm * static_cast<double>(gear.teeth));
}

void write_data(const DrawnGear& gear, const GearData& data, const Point& top, DxfSheet& sheet) {
  constexpr double kLine_mm = 1.7 * kText_mm;
  Point place = top;
  const auto line = [&](const std::string& words) {
    sheet.text(place, words);
    place.y -= kLine_mm;
  };
  line(fmt::format("{} ({})", data.gear, gear.symbol));
  for (const auto& [what, value] : data_lines(data)) line(fmt::format("{}: {}", what, value));
  if (!gear.form) line("outline: tip and root circles alone");
}

}  // namespace

std::vector<Point> dxf_middles(const DrawingLayout& layout) {
  constexpr double kGap_mm = 60.0;  // Room for the data.
  std::vector<Point> middles;
  double right_mm = 0.0;
  for (const DrawnGear& gear : layout.gears) {
    const double radius_mm = outer_radius_mm(layout, gear);
    middles.push_back({right_mm + radius_mm, 0.0});
    right_mm += 2.0 * radius_mm + kGap_mm;
  }
  return middles;
}

std::string gear_dxf(const DrawingLayout& layout, const std::vector<GearData>& data) {
  const MemoryFile file;
  std::vector<std::string> layers;
  for (const DrawnGear& gear : layout.gears) layers.push_back(layer_name(gear));
  layers.emplace_back(kPitchLayer);
  layers.emplace_back(kDataLayer);
  DxfSheet sheet(file.name());
  sheet.begin(layers);
  const std::vector<Point> middles = dxf_middles(layout);
  for (std::size_t i = 0; i < layout.gears.size(); ++i) {
    const DrawnGear& gear = layout.gears[i];
    const double radius_mm = outer_radius_mm(layout, gear);
    draw_gear(layout, gear, middles[i], sheet);
    write_data(gear, data[i], {middles[i].x - radius_mm, -radius_mm - 3.0 * kText_mm}, sheet);
  }
  sheet.end();
  return io::read_file_bytes(file.name());
}

}  // namespace torquewright::report
