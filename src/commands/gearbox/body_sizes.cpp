// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/body_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/given_once.hpp"
#include "io/text/stepped_range.hpp"

namespace torquewright::cli {
namespace {

constexpr double kWidestBore_mm = 1000.0;

std::vector<double> face_widths_mm(const StatedSizes& stated,
                                   const std::vector<double>& of_result_mm, std::size_t layers) {
  std::vector<double> widths_mm =
      stated.face_width_mm.empty() ? of_result_mm : stated.face_width_mm;
  if (widths_mm.size() > layers) {
    io::refuse("--face-width", fmt::format("has {} numbers; this train has {} layer{}",
                                           widths_mm.size(), layers, layers == 1 ? "" : "s"));
  }
  if (!stated.face_width_mm.empty()) widths_mm.resize(layers, widths_mm.front());
  if (stated.are_needed && widths_mm.size() < layers) {
    throw io::SpecError({{stated.file, "/problem/face_width_mm",
                          "missing, and solids need it; say --face-width MM (by layer: 10,8)"}});
  }
  return widths_mm;
}

double bore_mm(const std::string& item, const std::string& number) {
  const io::RangeRule rule{
      .refuse =
          [&item](const std::string&) {
            io::refuse("--bore", fmt::format("\"{}\": needs a diameter from 0 to {:g} mm", item,
                                             kWidestBore_mm));
          },
      .least = 0.0,
      .greatest = kWidestBore_mm};
  return io::nearest(io::read_range_number(number, rule));
}

}  // namespace

report::BodySizes body_sizes(const StatedSizes& stated, const std::vector<double>& of_result_mm,
                             const report::DrawingLayout& layout) {
  const gearbox::Topology& topology = *gearbox::find_topology(layout.drawing.topology);
  report::BodySizes sizes;
  sizes.face_width_mm = face_widths_mm(stated, of_result_mm, topology.layer_count());
  sizes.bore_mm.assign(topology.gears.size(), 0.0);
  sizes.bore_mm.front() = std::max(0.0, layout.drawing.hollow_shaft_diameter_mm);
  io::require_each_once("--bore", stated.bore);
  for (const std::string& item : stated.bore) {
    const std::size_t sign = item.find('=');
    const std::string gear = item.substr(0, sign);
    const auto bored = topology.gears.begin() + static_cast<std::ptrdiff_t>(topology.free_gears);
    const auto found = std::find(topology.gears.begin(), bored, gear);
    if (sign == std::string::npos || found == bored) {
      io::refuse("--bore",
                 fmt::format("\"{}\" names no gear with a bore; {} has {}, as in {}=5", item,
                             topology.name, fmt::join(topology.gears.begin(), bored, ", "),
                             topology.gears[1]));
    }
    sizes.bore_mm[static_cast<std::size_t>(found - topology.gears.begin())] =
        bore_mm(item, item.substr(sign + 1));
  }
  return sizes;
}

}  // namespace torquewright::cli
