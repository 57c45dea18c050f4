// SPDX-License-Identifier: Apache-2.0
// Feet that are meshes. Oracle: corners of boxes by hand, written as triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

#include "robot/draft/mesh_box.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

const std::string kMass =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
// Two triangles that span 0.25, 0.125 and 0.0625 m: no rounding as floats.
const Points kTriangles{{-0.0625, -0.0625, -0.0625}, {0.1875, 0, 0},       {0, 0.0625, 0},
                        {0.125, 0, -0.03125},        {0, -0.03125, -0.05}, {0.0625, 0.03125, 0}};
const Points kLowCorners{{0.1875, 0.0625, -0.0625},
                         {0.1875, -0.0625, -0.0625},
                         {-0.0625, 0.0625, -0.0625},
                         {-0.0625, -0.0625, -0.0625}};

std::string binary_stl(const Points& points) {
  std::string bytes(80, 's');
  const auto add = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  add(static_cast<std::uint32_t>(points.size() / 3));
  for (std::size_t i = 0; i < points.size(); i += 3) {
    for (int k = 0; k < 3; ++k) add(9.0F);  // the normal, which is no corner
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      for (const double number : points[corner]) add(static_cast<float>(number));
    }
    add(std::uint16_t{0});
  }
  return bytes;
}

std::string text_of(const Points& points, const std::string& head, const std::string& word) {
  std::string text = head;
  for (const Vector3d& point : points) {
    text += word;
    for (const double number : point) text += " " + std::to_string(number);
    text += "\n";
  }
  return text;
}

void expect_points(const Robot& robot, const Points& points) {
  ASSERT_EQ(robot.contacts.size(), points.size());
  for (const Vector3d& point : points) {
    EXPECT_TRUE(std::any_of(robot.contacts.begin(), robot.contacts.end(), [&](const auto& contact) {
      return (contact.point.p_B_m - point).norm() < 1e-12;
    })) << point.transpose();
  }
}

Imported with_foot(const test::ScratchFolder& folder, const std::string& mesh,
                   const std::string& name = "left_foot") {
  return read_urdf(folder.write(
      "r.urdf", "<robot name='r'><link name='trunk'>" + kMass + "</link><link name='" + name +
                    "'>" + kMass + "<collision><geometry>" + mesh +
                    "</geometry></collision></link><joint name='j' type='continuous'><parent "
                    "link='trunk'/><child link='" +
                    name + "'/></joint></robot>"));
}

TEST(MeshFeet, AreTheLowerCornersOfTheirBox) {
  const test::ScratchFolder folder;
  folder.write("foot.STL", binary_stl(kTriangles));
  folder.write("text.stl", text_of(kTriangles, "solid foot\nfacet normal 9 9 9\n", "   vertex"));
  folder.write("foot.obj", text_of(kTriangles, "vn 9 9 9\nf 1 2 3\n", "v"));
  for (const char* file : {"foot.STL", "text.stl", "foot.obj"}) {
    const Imported read = with_foot(folder, "<mesh filename='" + std::string(file) + "'/>");
    expect_points(read.robot, kLowCorners);
    EXPECT_NE(test::all_of(read.notes).find("4 of left_foot's mesh (its bounding box)"),
              std::string::npos)
        << test::all_of(read.notes);
  }
}

TEST(MeshFeet, AreScaledAndFoundInPackages) {
  const test::ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "meshes");
  Points large = kTriangles;
  for (Vector3d& point : large) point = 1000 * Vector3d(point.x(), -point.y(), point.z());
  folder.write("meshes/foot.obj", text_of(large, "", "v"));
  for (const char* file : {"package://legs/meshes/foot.obj", "meshes/foot.obj"}) {
    expect_points(
        with_foot(folder, "<mesh scale='0.001 -0.001 0.001' filename='" + std::string(file) + "'/>")
            .robot,
        kLowCorners);
  }
}

TEST(MeshFeet, ThatSayNothingAreNamed) {
  const test::ScratchFolder folder;
  folder.write("empty.stl", "solid nothing\nendsolid\n");
  folder.write("foot.dae", "<COLLADA/>");
  folder.write("nan.obj", "v 1 2 nan\n");
  folder.write("huge.obj", text_of(kTriangles, "v 9e9 0 0\n", "v"));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  folder.write("nan.stl", binary_stl({{nan, 0, 0}, {1, 1, 1}, {0, 1, 0}}));
  for (const auto& [file, why] : {std::pair{"empty.stl", "holds no points"},
                                  {"foot.dae", "is neither STL nor OBJ"},
                                  {"gone.stl", "is not there"},
                                  {"nan.obj", "without three numbers"},
                                  {"huge.obj", "is larger than 100 m"},
                                  {"nan.stl", "not finite"}}) {
    const Imported read = with_foot(folder, "<mesh filename='" + std::string(file) + "'/>");
    EXPECT_TRUE(read.robot.contacts.empty());
    EXPECT_NE(test::all_of(read.notes).find(why), std::string::npos) << test::all_of(read.notes);
    EXPECT_NE(test::all_of(read.notes).find("no contact points"), std::string::npos);
  }
}

TEST(MeshFeet, AreLeavesOfLegsAndNoOthers) {
  const test::ScratchFolder folder;
  folder.write("foot.stl", binary_stl(kTriangles));
  const std::string mesh = "<mesh filename='foot.stl'/>";
  expect_points(with_foot(folder, mesh, "left_calf").robot, kLowCorners);
  EXPECT_TRUE(with_foot(folder, mesh, "tail").robot.contacts.empty());
  EXPECT_TRUE(with_foot(folder, mesh, "left_hand").robot.contacts.empty());
}

// A mesh whose points the file states, one that lies in its folder, and one that collides with
// nothing.
TEST(MeshFeet, OfMjcfComeFromItsAssets) {
  const test::ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "meshes");
  folder.write("meshes/foot.stl", binary_stl(kTriangles));
  std::string vertices;
  for (const Vector3d& point : kTriangles) {
    for (const double number : point) vertices += std::to_string(number) + " ";
  }
  for (const std::string& asset :
       {"<mesh name='foot' vertex='" + vertices + "'/>", std::string("<mesh file='foot.stl'/>")}) {
    const Imported read = read_mjcf(folder.write(
        "r.xml",
        "<mujoco><compiler meshdir='meshes'/><asset>" + asset +
            "</asset><worldbody><body name='trunk'><freejoint/><inertial mass='1' pos='0 0 0' "
            "diaginertia='1 1 1'/><body name='left_foot'><joint name='j'/><inertial mass='1' "
            "pos='0 0 0' diaginertia='1 1 1'/><geom type='mesh' mesh='foot' contype='0' "
            "conaffinity='0' pos='0 0 9'/><geom type='mesh' mesh='foot' friction='0.7'/>"
            "</body></body></worldbody></mujoco>"));
    expect_points(read.robot, kLowCorners);
    EXPECT_EQ(read.robot.contacts.front().friction_coefficient, 0.7);
  }
}

// Oracle: the pair's own friction, before the geom's.
TEST(PairedFeet, TouchWhateverTheirMasksSay) {
  const test::ScratchFolder folder;
  const std::string geom =
      "<geom name='sole' type='box' size='0.1 0.05 0.01' contype='0' "
      "conaffinity='0' friction='1'/>";
  const auto text = [&](const std::string& contact) {
    return "<mujoco><worldbody><geom name='floor' type='plane' size='1 1 1'/><body name='trunk'>"
           "<freejoint/><inertial mass='1' pos='0 0 0' diaginertia='1 1 1'/><body name='leg'>"
           "<joint name='j'/><inertial mass='1' pos='0 0 0' diaginertia='1 1 1'/>" +
           geom + "</body></body></worldbody>" + contact + "</mujoco>";
  };
  EXPECT_TRUE(read_mjcf(folder.write("r.xml", text(""))).robot.contacts.empty());
  const Imported read = read_mjcf(folder.write(
      "r.xml", text("<contact><pair geom1='sole' geom2='floor' friction='0.6 0.6'/></contact>")));
  ASSERT_EQ(read.robot.contacts.size(), 4u);
  EXPECT_EQ(read.robot.contacts.front().friction_coefficient, 0.6);
}

}  // namespace
}  // namespace torquewright::hopper
