// SPDX-License-Identifier: Apache-2.0
// Every public robot that is there: read as MuJoCo reads it, or refused, and which of both stands
// in docs/imported_robots.md. Oracle: MuJoCo 2.2.2 on the same file without what it cannot open and
// what moves nothing; its bodies of several shapes as several bodies.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "io/faults/spec_error.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/real_data/robots/stripped_mjcf.hpp"
#include "tests/robot/mujoco_twin.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

constexpr double kSame = 1e-10;  // the goal; what is found are roundings, at most 1e-11

fs::path robots() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path source = TORQUEWRIGHT_SOURCE_DIR;
  const fs::path data = variable != nullptr ? fs::path(variable) : source / "../shared/data";
  return fs::is_directory(data / "robots") ? fs::canonical(data / "robots") : fs::path();
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

Imported read_file(const fs::path& file, const ImportFileOptions& options) {
  return file.extension() == ".urdf" ? read_urdf(file, options) : read_mjcf(file, options);
}

/// The first sentence of a refusal, without the folder of all robots: the page is the same on every
/// machine.
std::string sentence_of(const io::SpecError& error) {
  std::string message = error.faults().front().message;
  const std::string folder = robots().string() + "/";
  for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
    message.erase(at, folder.size());
  }
  return fmt::format("{}: {}", fs::path(error.faults().front().file).filename().string(), message);
}

/// The names in "the world holds 2 bodies that move (cup, ball)": each is a robot of its own.
std::vector<std::string> bodies_in(const std::string& sentence) {
  std::smatch found;
  std::vector<std::string> names;
  if (!std::regex_search(sentence, found,
                         std::regex(R"(the world holds \d+ bodies that move \((.*)\);)"))) {
    return names;
  }
  const std::string list = found[1];
  const std::regex comma(", ");
  for (std::sregex_token_iterator next(list.begin(), list.end(), comma, -1), end; next != end;
       ++next) {
    if (next->length() > 0) names.push_back(*next);
  }
  return names;
}

/// Where MuJoCo numbers the robot: its top body, which the robot's first or second one is.
std::string top_of(const Robot& robot, const std::string& body, const mjModel& model) {
  if (!body.empty()) return body;
  for (const dynamics::Body& next : robot.tree.bodies) {
    const std::string name = next.name.substr(0, next.name.find('.'));
    if (mj_name2id(&model, mjOBJ_BODY, name.c_str()) > 0) return name;
  }
  return "";
}

/// Of one body of a file, or of its only one.
struct Verdict {
  bool is_read = false;
  std::string sentence = {};  ///< Why not; or why there is nothing to compare with.
  double difference = 0;
};

bool has_balls(const mjModel& model) {
  return std::find(model.jnt_type, model.jnt_type + model.njnt, mjJNT_BALL) !=
         model.jnt_type + model.njnt;
}

double greatest(const test::TwinDifference& far) {
  return std::max(
      {far.mass, far.place_m, far.inertia, far.matrix, far.bias, far.range, far.passive});
}

Verdict compared(const fs::path& file, const Robot& robot, const ImportFileOptions& options) {
  if (file.extension() == ".urdf") return {true, "not compared: meshes missing"};
  try {
    test::MujocoEngine mujoco(test::stripped_mjcf(file));
    if (options.drops_base_armature) mju_zero(mujoco.model().dof_armature, 6);
    mju_zero(mujoco.model().opt.gravity, 2);  // a tilt that is said
    if (has_balls(mujoco.model())) {
      return {true, "not compared: its ball joints are three hinges each"};
    }
    const test::TwinDifference far =
        test::compare_with_mujoco(robot, mujoco, top_of(robot, options.body, mujoco.model()));
    EXPECT_EQ(far.trouble, "") << file;
    return {true, "", greatest(far)};
  } catch (const std::runtime_error& error) {
    const std::string why = error.what();
    return {true, fmt::format("not compared: {}", why.substr(0, why.find('\n')))};
  }
}

/// With the options that its own refusal offers.
Verdict verdict_of(const fs::path& file, ImportFileOptions options) {
  try {
    return compared(file, read_file(file, options).robot, options);
  } catch (const io::SpecError& error) {
    const std::string sentence = sentence_of(error);
    const auto offers = [&](const char* option, bool& is_taken) {
      const bool is_new = !is_taken && sentence.find(option) != std::string::npos;
      is_taken = is_taken || is_new;
      return is_new;
    };
    for (const auto& [option, taken] :
         {std::pair{"--drop-base-armature", &options.drops_base_armature},
          std::pair{"--free-couplings", &options.frees_couplings},
          std::pair{"--mend-inertias", &options.mends_inertias}}) {
      if (!offers(option, *taken)) continue;
      Verdict again = verdict_of(file, options);
      if (again.is_read) again.sentence = again.sentence + " by " + option;
      return again;
    }
    return {false, sentence};
  }
}

enum class Class { kRead, kRefused, kNoRobot, kNeedsMesh };

struct Row {
  std::string file;
  Class is = Class::kRefused;
  std::string said;
  double difference = 0;
};

Class class_of(const std::string& sentence) {
  const auto has = [&](const char* part) { return sentence.find(part) != std::string::npos; };
  if (has("attribute mesh")) return Class::kNeedsMesh;
  const bool is_part = has("holds no body") || has("holds no worldbody") ||
                       has("must hold <mujoco>") || has("is not there") ||
                       has("0 bodies that move");
  return is_part ? Class::kNoRobot : Class::kRefused;
}

/// A scene of several bodies counts by all of them that are robots, at most so many.
constexpr std::size_t kMostBodies = 12;

Row row_of_scene(Row row, const fs::path& file, const std::vector<std::string>& bodies) {
  std::string read;
  std::string refused;
  for (std::size_t i = 0; i < std::min(bodies.size(), kMostBodies); ++i) {
    const Verdict one = verdict_of(file, {bodies[i]});
    row.difference = std::max(row.difference, one.difference);
    if (one.is_read) {
      read += (read.empty() ? "" : ", ") + bodies[i] + one.sentence;
    } else {
      refused += fmt::format("{}{} ({})", refused.empty() ? "" : "; ", bodies[i], one.sentence);
    }
  }
  row.is = refused.empty() ? Class::kRead : class_of(refused);
  if (!read.empty()) row.said = "read by --body: " + read;
  if (!refused.empty()) row.said += (read.empty() ? "refused: " : "; refused: ") + refused;
  if (bodies.size() > kMostBodies) row.said += fmt::format("; {} in all", bodies.size());
  return row;
}

Row row_of(const fs::path& file) {
  Row row{file.lexically_relative(robots()).generic_string(), Class::kRefused, ""};
  const Verdict whole = verdict_of(file, {});
  const std::vector<std::string> bodies = bodies_in(whole.sentence);
  if (!bodies.empty()) return row_of_scene(std::move(row), file, bodies);
  row.is = whole.is_read ? Class::kRead : class_of(whole.sentence);
  row.said = whole.sentence;
  row.difference = whole.difference;
  return row;
}

const char* name_of(Class is) {
  switch (is) {
    case Class::kRead:
      return "read";
    case Class::kRefused:
      return "refused";
    case Class::kNoRobot:
      return "no robot";
    case Class::kNeedsMesh:
      return "needs a mesh";
  }
  return "";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '<' || letter == '|' || letter == '_' || letter == '*') out += '\\';
    out += letter;
  }
  return out;
}

std::string table_of(const std::vector<Row>& rows) {
  std::string text = "| file | verdict | what is said |\n|---|---|---|\n";
  for (const Row& row : rows) {
    text +=
        fmt::format("| {} | {} | {} |\n", escaped(row.file), name_of(row.is), escaped(row.said));
  }
  return text;
}

std::size_t count(const std::vector<Row>& rows, Class is) {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return row.is == is; }));
}

std::size_t count_by_option(const std::vector<Row>& rows) {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const Row& row) {
    const bool has_option = row.said.find("--drop-base-armature") != std::string::npos ||
                            row.said.find("--free-couplings") != std::string::npos ||
                            row.said.find("--mend-inertias") != std::string::npos;
    return row.is == Class::kRead && has_option;
  }));
}

bool mujoco_reads(const fs::path& file) {
  try {
    test::MujocoEngine mujoco(test::stripped_mjcf(file));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

bool is_compared(const Row& row) { return row.said.find("not compared") == std::string::npos; }

/// A refusal is right where the file holds no robot or needs a mesh, or where MuJoCo, without
/// meshes, refuses it too.
std::string classes_of(const std::vector<Row>& rows) {
  std::size_t right = 0, wrong = 0, apart = 0, readable = 0, rightly = 0;
  for (const Row& row : rows) {
    if (row.is == Class::kRead) {
      ++(row.difference > kSame ? wrong : is_compared(row) ? right : apart);
    } else {
      const bool is_readable = row.is == Class::kRefused && mujoco_reads(robots() / row.file);
      ++(is_readable ? readable : rightly);
    }
  }
  return fmt::format(
      "In four classes: {} right (as MuJoCo reads them; {} more read but not compared), {} refused "
      "rightly (no robot, a mesh is needed, or MuJoCo refuses it too), {} wrong (read, but not as "
      "MuJoCo), {} refused "
      "though readable (MuJoCo reads them without a mesh).",
      right, apart, rightly, wrong, readable);
}

std::string document_of(const std::vector<Row>& rows) {
  return fmt::format(
      "{} files: {} read ({} of them by an option that their refusal offers), {} refused, {} hold "
      "no "
      "robot, {} need a mesh. Of those that hold a robot and need no mesh {:.0f} % are "
      "read.\n\n{}\n\n{}",
      rows.size(), count(rows, Class::kRead), count_by_option(rows), count(rows, Class::kRefused),
      count(rows, Class::kNoRobot), count(rows, Class::kNeedsMesh),
      100.0 * static_cast<double>(count(rows, Class::kRead)) /
          static_cast<double>(count(rows, Class::kRead) + count(rows, Class::kRefused)),
      classes_of(rows), table_of(rows));
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    mju_user_warning = [](const char*) {};  // of its room for contacts, which play no part
    std::vector<Row> found;
    for (const fs::path& file : files()) found.push_back(row_of(file));
    return found;
  }();
  return all;
}

TEST(PublicRobots, AreReadAsMujocoReadsThem) {
  if (robots().empty()) GTEST_SKIP() << "needs the public robots, ../shared/data";
  double worst = 0;
  for (const Row& row : rows()) {
    EXPECT_LE(row.difference, kSame) << row.file;
    worst = std::max(worst, row.difference);
  }
  std::printf("worst difference from MuJoCo: %.2g\n%s\n", worst, classes_of(rows()).c_str());
}

TEST(PublicRobots, AreReadWhereTheyNeedNoMesh) {
  if (robots().empty()) GTEST_SKIP() << "needs the public robots, ../shared/data";
  EXPECT_GE(count(rows(), Class::kRead), 4 * count(rows(), Class::kRefused));
}

// The page is what this program finds: `imported_robots_test --gtest_also_run_disabled_tests
// --gtest_filter=*Prints` prints its end.
TEST(PublicRobots, StandInTheDocuments) {
  if (robots().empty()) GTEST_SKIP() << "needs the public robots, ../shared/data";
  std::ifstream stream(TORQUEWRIGHT_SOURCE_DIR "/docs/imported_robots.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(page.find(document_of(rows())), std::string::npos);
}

TEST(DISABLED_PublicRobots, Prints) {
  if (!robots().empty()) std::printf("%s", document_of(rows()).c_str());
}

}  // namespace
}  // namespace torquewright::hopper
