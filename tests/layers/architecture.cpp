// SPDX-License-Identifier: Apache-2.0
#include "tests/layers/architecture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "tests/layers/layers.hpp"
#include "tests/layers/room_sizes.hpp"

namespace torquewright::layers {
namespace {

using Below = std::map<std::string, std::set<std::string>>;

/// What a folder holds, for who looks for a place.
const std::map<std::string, std::string> kHolds = {
    {"io", "documents, files, units, words: everything may use it"},
    {"optimization", "expressions, intervals, branch and bound, nonlinear programs"},
    {"learning", "networks and proximal policy optimisation; knows no robot"},
    {"gearbox", "teeth, trains, their conditions, search, strength and proofs"},
    {"actuator", "motor, drive, effects, the region, checks of a motion, exporters"},
    {"dynamics", "trees of rigid bodies, on any scalar"},
    {"robot", "the robot document, mechanisms, readers and writers of URDF and MJCF"},
    {"simulation", "what moves in time: joints with their effects, plants, steppers, contact"},
    {"hopper", "motions, whole-body checks, planning, tracking, replay"},
    {"identification", "logs, the forward model, the search for effects, plans of experiments"},
    {"src", "the program: commands, their options, what they print and draw"},
    {"python", "the module for Python"},
};

/// How many folders stand below, one on the other.
std::size_t height_of(const std::string& folder, const Below& below) {
  std::size_t height = 0;
  for (const std::string& other : below.at(folder)) {
    height = std::max(height, height_of(other, below) + 1);
  }
  return height;
}

std::string in_words(const std::set<std::string>& names) {
  return names.empty() ? "-" : fmt::format("{}", fmt::join(names, ", "));
}

/// From the top down.
std::vector<std::vector<std::string>> storeys(const Below& below) {
  std::vector<std::vector<std::string>> all;
  for (const auto& [folder, others] : below) {
    const std::size_t height = height_of(folder, below);
    if (all.size() <= height) all.resize(height + 1);
    all[height].push_back(folder);
  }
  std::reverse(all.begin(), all.end());
  return all;
}

}  // namespace

std::string architecture_tables(const std::filesystem::path& root) {
  const Below below = folders_below();
  std::map<std::string, RoomSize> sizes;
  for (RoomSize& size : room_sizes(root)) sizes[size.room] = size;
  std::string text =
      "| folder | holds | may include |\n"
      "|---|---|---|\n";
  for (const auto& storey : storeys(below)) {
    for (const std::string& folder : storey) {
      text += fmt::format("| `{}` | {} | {} |\n", folder, kHolds.at(folder),
                          in_words(below.at(folder)));
    }
  }
  text += "\n| room | files | floors | may include, of its folder's |\n|---|---|---|---|\n";
  for (const auto& [name, size] : sizes) {
    const std::size_t slash = name.find('/');
    const std::string room = slash == std::string::npos ? "" : name.substr(slash + 1);
    const Below rooms = rooms_below(name.substr(0, slash));
    text += fmt::format("| `{}` | {} | {} | {} |\n", name, size.files, size.floors,
                        room.empty() || !rooms.contains(room) ? "-" : in_words(rooms.at(room)));
  }
  return text;
}

std::string architecture_picture() {
  constexpr int kWidth = 640, kRow = 56, kBox = 34;
  const auto rows = storeys(folders_below());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" role=\"img\" font-family=\"sans-serif\" font-size=\"14\">\n"
      "<title>Folders, each above those that it may include</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      kWidth, kRow * static_cast<int>(rows.size()) + 8);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const int count = static_cast<int>(rows[row].size());
    const int width = (kWidth - 16) / count;
    for (int i = 0; i < count; ++i) {
      const int x = 8 + i * width, y = 12 + static_cast<int>(row) * kRow;
      svg += fmt::format(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"4\" fill=\"#e8eef4\" "
          "stroke=\"#34495e\"/>\n"
          "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"#1c2833\">{}</text>\n",
          x + 4, y, width - 8, kBox, x + width / 2, y + 22, rows[row][static_cast<std::size_t>(i)]);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace torquewright::layers
