// SPDX-License-Identifier: Apache-2.0
// Formats: STL as in "The StL Format" (3D Systems), 50 bytes a triangle behind 84, little endian;
// OBJ's vertices, "v x y z".
#include "robot/draft/mesh_box.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>

#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "io/text/letter_case.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHead_bytes = 84;
constexpr std::size_t kTriangle_bytes = 50;

class Grower {
 public:
  void take(const Vector3d& point) {
    is_sound_ = is_sound_ && point.allFinite();
    least_ = least_.cwiseMin(point);
    most_ = most_.cwiseMax(point);
    has_points_ = true;
  }
  std::variant<MeshBox, std::string> box() const {
    if (!has_points_) return "holds no points";
    if (!is_sound_) return "holds points that are not finite";
    return MeshBox{least_, most_};
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vector3d least_ = Vector3d::Constant(kFar);
  Vector3d most_ = Vector3d::Constant(-kFar);
  bool has_points_ = false, is_sound_ = true;
};

template <typename T>
T at(std::string_view bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHead_bytes) return false;
  const std::uint64_t triangles = at<std::uint32_t>(bytes, kHead_bytes - 4);
  return bytes.size() == kHead_bytes + kTriangle_bytes * triangles;
}

/// Three corners of each triangle behind its normal.
std::variant<MeshBox, std::string> of_binary_stl(std::string_view bytes) {
  Grower grower;
  for (std::size_t triangle = kHead_bytes; triangle < bytes.size(); triangle += kTriangle_bytes) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const std::size_t place = triangle + 12 * corner;
      grower.take(
          {at<float>(bytes, place), at<float>(bytes, place + 4), at<float>(bytes, place + 8)});
    }
  }
  return grower.box();
}

/// Lines of this word and three numbers.
std::variant<MeshBox, std::string> of_lines(const std::string& bytes, const std::string& word) {
  Grower grower;
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    Vector3d point;
    if (!(words >> first) || first != word) continue;
    if (!(words >> point[0] >> point[1] >> point[2])) return "holds a point without three numbers";
    grower.take(point);
  }
  return grower.box();
}

}  // namespace

std::variant<MeshBox, std::string> mesh_box(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return "is not there";
  std::string bytes;
  try {
    bytes = io::read_file_bytes(file);
  } catch (const io::SpecError&) {
    return "cannot be read";
  }
  const std::string ending = io::in_small_letters(file.extension().string());
  if (ending == ".obj") return of_lines(bytes, "v");
  if (ending != ".stl") return "is neither STL nor OBJ";
  return is_binary_stl(bytes) ? of_binary_stl(bytes) : of_lines(bytes, "vertex");
}

}  // namespace torquewright::hopper
