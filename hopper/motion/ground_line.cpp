// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/ground_line.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using simulation::GroundProfile;

constexpr std::string_view kGroundKey = "ground profile:";
constexpr std::string_view kHeightWord = "z = ";
constexpr std::string_view kEdgeWord = " m up to x = ";
constexpr std::string_view kNextWord = " m, then ";
constexpr std::string_view kEndWord = " m";
constexpr double kGroundWithin_m = 1000.0;

std::string_view bare_comment(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '#')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Takes words and numbers from the left of a text.
class GroundText {
 public:
  explicit GroundText(std::string_view text) : left_(text) {}

  bool takes(std::string_view words) {
    if (!left_.starts_with(words)) return false;
    left_.remove_prefix(words.size());
    return true;
  }
  bool takes_number(double& number) {
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), number);
    if (error != std::errc() || !(std::abs(number) <= kGroundWithin_m)) return false;
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return true;
  }
  bool is_done() const { return left_.empty(); }

 private:
  std::string_view left_;
};

bool is_ground(std::string_view text, GroundProfile& ground) {
  GroundText words(text);
  while (true) {
    double height_m = 0.0, edge_x_m = 0.0;
    if (!words.takes(kHeightWord) || !words.takes_number(height_m)) return false;
    ground.heights_m.push_back(height_m);
    if (!words.takes(kEdgeWord)) break;
    if (!words.takes_number(edge_x_m) || !words.takes(kNextWord)) return false;
    if (!ground.edges_x_m.empty() && !(edge_x_m > ground.edges_x_m.back())) return false;
    ground.edges_x_m.push_back(edge_x_m);
  }
  return words.takes(kEndWord) && words.is_done() && !ground.edges_x_m.empty();
}

}  // namespace

std::string ground_words(const GroundProfile& ground) {
  if (ground.is_flat()) return "flat";
  std::string words;
  for (std::size_t i = 0; i < ground.heights_m.size(); ++i) {
    words += fmt::format("{}{}", kHeightWord, ground.heights_m[i] + 0.0);
    if (i < ground.edges_x_m.size()) {
      words += fmt::format("{}{}{}", kEdgeWord, ground.edges_x_m[i] + 0.0, kNextWord);
    }
  }
  return words + std::string(kEndWord);
}

std::string ground_line(const GroundProfile& ground) {
  return ground.is_flat() ? "" : fmt::format("# {} {}\n", kGroundKey, ground_words(ground));
}

GroundProfile read_ground(const std::vector<std::string>& comments, const std::string& file) {
  GroundProfile ground;
  for (const std::string& comment : comments) {
    const std::string_view text = bare_comment(comment);
    if (!text.starts_with(kGroundKey)) continue;
    if (!ground.is_flat()) io::refuse(file, fmt::format("says twice what its ground is: {}", text));
    if (!is_ground(bare_comment(text.substr(kGroundKey.size())), ground)) {
      io::refuse(file, fmt::format("\"{}\" is no ground; it reads as \"# {} z = 0 m up to x = 0.3 "
                                   "m, then z = 0.085 m\", with edges that ascend",
                                   text, kGroundKey));
    }
  }
  return ground;
}

}  // namespace torquewright::hopper
