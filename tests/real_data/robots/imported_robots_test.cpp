// SPDX-License-Identifier: Apache-2.0
// Every public robot that is there: read as MuJoCo reads it, or refused, and which of both stands
// in docs/imported_robots.md. Oracle: MuJoCo 2.2.2 on the same file without what it cannot open.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "hopper/files/mjcf_reader.hpp"
#include "hopper/files/urdf_reader.hpp"
#include "io/spec_error.hpp"
#include "tests/hopper/mujoco_twin.hpp"
#include "tests/real_data/robots/stripped_mjcf.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

// MuJoCo finds principal axes of moments by its own rotations, to some 1e-9 of them.
constexpr double kSame = 1e-8;

fs::path robots() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path source = TORQUEWRIGHT_SOURCE_DIR;
  const fs::path data = variable != nullptr ? fs::path(variable) : source / "../shared/data";
  return fs::is_directory(data / "robots") ? data / "robots" : fs::path();
}

std::vector<fs::path> files() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(robots())) {
    const fs::path ending = entry.path().extension();
    if (ending == ".xml" || ending == ".urdf") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The names in "the world holds 2 bodies (cup, ball)": each is a robot of its own.
std::vector<std::string> bodies_in(const std::string& message) {
  std::vector<std::string> names;
  const std::size_t open = message.find(" bodies (");
  if (open == std::string::npos) return names;
  const std::size_t start = open + 9;
  std::string list = message.substr(start, message.find(')', start) - start);
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t comma = std::min(list.find(", ", at), list.size());
    names.push_back(list.substr(at, comma - at));
    at = comma + 2;
  }
  return names;
}

TEST(Try, Survey) {
  if (robots().empty()) GTEST_SKIP() << "needs the public robots, ../shared/data";
  for (const fs::path& file : files()) {
    const std::string name = file.lexically_relative(robots()).generic_string();
    std::setvbuf(stdout, nullptr, _IONBF, 0);
    std::printf("-- %s\n", name.c_str());
    std::vector<std::string> tops{""};
    for (std::size_t i = 0; i < tops.size(); ++i) {
      try {
        const Imported read = file.extension() == ".urdf" ? read_urdf(file, {tops[i], false})
                                                          : read_mjcf(file, {tops[i], false});
        if (file.extension() == ".urdf") continue;
        std::string top = tops[i];
        if (top.empty()) {
          const auto& bodies = read.robot.tree.bodies;
          top = bodies[0].name == "world" && bodies.size() > 1 ? bodies[1].name : bodies[0].name;
        }
        test::MujocoEngine mujoco(test::stripped_mjcf(file));
        const auto cut = top.find('.');
        if (mj_name2id(&mujoco.model(), mjOBJ_BODY, top.c_str()) < 0)
          top = cut == std::string::npos ? "" : top.substr(0, cut);
        const auto d = test::compare_with_mujoco(read.robot, mujoco, top);
        std::printf("READ %s [%s] m %.1e c %.1e I %.1e M %.1e b %.1e r %.1e %s\n", name.c_str(),
                    top.c_str(), d.mass, d.place_m, d.inertia, d.matrix, d.bias, d.range,
                    d.trouble.c_str());
      } catch (const io::SpecError& error) {
        const std::string message = error.what();
        if (tops[i].empty())
          for (auto& n : bodies_in(message))
            if (!n.empty() && tops.size() < 12) tops.push_back(n);
        std::printf("REFUSED %s [%s] %s\n", name.c_str(), tops[i].c_str(),
                    message.substr(0, message.find('\n')).c_str());
      } catch (const std::exception& error) {
        std::printf("NOORACLE %s [%s] %s\n", name.c_str(), tops[i].c_str(), error.what());
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::hopper
