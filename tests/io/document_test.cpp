// SPDX-License-Identifier: Apache-2.0
#include "io/documents/document.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <limits>
#include <thread>

#include "io/files/file_bytes.hpp"
#include "io/files/sha256.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;
using test::ScratchFolder;

constexpr std::string_view kKnee = R"({
  "kind": "gearbox_problem", "version": 1, "name": "knee", "topology": "3k", "target_ratio": 20.0,
  "ratio_tolerance": 0, "rotor_inner_diameter_mm": 79.4, "module_mm": 0.6, "planet_count": 4,
  "min_teeth": {"sun": 40, "planet_1": 40, "planet_2": 30}, "min_carrier_clearance_rad": 0.26,
  "constraints": "paper", "objective": "paper_cost", "assumed": ["/min_teeth"]})";

TEST(ReadDocument, GivesTheValuesAndTheHashOfTheBytes) {
  const ScratchFolder folder;
  const auto file = folder.write("knee.json", kKnee);
  const Document document = read_document(file, "gearbox_problem");
  EXPECT_EQ(document.file, file.string());
  EXPECT_EQ(document.sha256, sha256(kKnee));
  EXPECT_EQ(document.root["rotor_inner_diameter_mm"], 79.4);
  EXPECT_TRUE(document.root["target_ratio"].is_number_integer());  // 20.0
}

// A document without a name is called as its file is; one with a name has one to be called by.
TEST(ReadDocument, RefusesABlankName) {
  const std::filesystem::path specs = TORQUEWRIGHT_SOURCE_DIR "/specs";
  for (const auto& [file, kind] : {std::pair{"actuator/d151_knee.json", "actuator"},
                                   {"gearbox/d151_strength.json", "gear_strength"},
                                   {"gearbox/d151_knee.json", "gearbox_problem"},
                                   {"trajectory/parallel_ankle_table.json", "jacobian"},
                                   {"randomisation/hopper.json", "randomisation"},
                                   {"rig/knee_sweep.json", "rig"},
                                   {"robot/hopper.json", "robot"},
                                   {"trajectory/cassie_columns.json", "trajectory_columns"}}) {
    json root = read_document(specs / file, kind).root;
    root["name"] = " k ";
    EXPECT_NO_THROW(check_document(root, kind, "a.json", "")) << file;
    for (const char* blank : {"", " ", "   "}) {
      root["name"] = blank;
      try {
        check_document(root, kind, "a.json", "");
        ADD_FAILURE() << file;
      } catch (const SpecError& error) {
        EXPECT_EQ(error.what(),
                  "a.json#/name: \"" + std::string(blank) + "\" is blank, must hold a character");
      }
    }
  }
}

TEST(ReadDocument, AcceptsAByteOrderMark) {
  const ScratchFolder folder;
  const std::string text = "\xEF\xBB\xBF" + std::string(kKnee);
  EXPECT_NO_THROW(read_document(folder.write("knee.json", text), "gearbox_problem"));
}

TEST(ReadDocument, AgreesWithCheckDocument) {
  const Document document = check_document(json::parse(kKnee), "gearbox_problem", "r.json", "/p");
  EXPECT_EQ(document.file, "r.json");
  EXPECT_EQ(document.path, "/p");
  EXPECT_EQ(document.sha256, sha256(document.root.dump()));
}

TEST(CheckDocument, SaysWhereItStands) {
  json root = json::parse(kKnee);
  root["topology"] = "4k";
  root["assumed"] = {"/none"};
  try {
    check_document(root, "gearbox_problem", "result.json", "/problem");
    FAIL();
  } catch (const SpecError& error) {
    EXPECT_STREQ(error.what(),
                 "result.json#/problem/topology: \"4k\" is not one of \"3k\", \"planetary\", "
                 "\"3k_b\", \"compound\", \"any\"\n"
                 "result.json#/problem/assumed/0: \"/none\" points at nothing; must be the JSON "
                 "pointer of a value of this document");
  }
}

TEST(CheckDocument, LetsNoNanThrough) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    json root = json::parse(kKnee);
    root["synthesis"] = {{"a", {1, value}}};  // where the schema itself would let it pass
    try {
      check_document(root, "gearbox_problem", "r.json", "");
      FAIL();
    } catch (const SpecError& error) {
      EXPECT_STREQ(error.what(), "r.json#/synthesis/a/1: is no number, must be finite");
    }
  }
}

TEST(CheckDocument, RefusesAKindThatNobodyKnows) {
  EXPECT_THROW(check_document(json::object(), "gearbix", "r.json", ""), std::invalid_argument);
}

std::string refusal_to_read(const std::filesystem::path& file) {
  try {
    read_document(file, "gearbox_problem");
    return "";
  } catch (const SpecError& error) {
    return error.what();
  }
}

TEST(ReadDocument, RefusesWhatIsNoReadableFile) {
  const ScratchFolder folder;
  const std::string name = folder.path().string();
  EXPECT_EQ(refusal_to_read(folder.path() / "none.json"), name + "/none.json: no such file");
  EXPECT_EQ(refusal_to_read(folder.path()), name + ": is a folder, must be a file");
  EXPECT_EQ(refusal_to_read("/proc/self/mem"),
            "/proc/self/mem: cannot be read: Input/output error");
  // Who may read it gets to where it waits for the kernel's next message, which may never come.
  EXPECT_EQ(refusal_to_read("/proc/kmsg").find("/proc/kmsg: cannot be read: "), 0u);
  EXPECT_EQ(refusal_to_read("/dev/zero"), "/dev/zero: holds more than the allowed 64 MiB");
}

// Just inside and just outside the limit; the file is sparse.
TEST(ReadDocument, RefusesAHugeFileBeforeReadingIt) {
  const ScratchFolder folder;
  const auto file = folder.write("a", "");
  std::filesystem::resize_file(file, kMaxFileBytes);
  EXPECT_EQ(refusal_to_read(file), file.string() + ": line 1, column 1: not JSON: zero byte");
  std::filesystem::resize_file(file, kMaxFileBytes + 1);
  EXPECT_EQ(refusal_to_read(file),
            file.string() + ": holds 67108865 bytes, more than the allowed 64 MiB");
}

/// What so many bytes from a pipe are refused with, without the pipe's name.
std::string refusal_from_pipe(std::size_t bytes) {
  const ScratchFolder folder;
  const std::string pipe = (folder.path() / "pipe").string();
  EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << std::string(bytes, ' '); });
  const std::string why = refusal_to_read(pipe);
  writer.join();
  return why.substr(pipe.size());
}

// A pipe does not tell its size beforehand. Just inside and just outside the limit.
TEST(ReadDocument, RefusesTooMuchFromAPipe) {
  EXPECT_NE(refusal_from_pipe(kMaxFileBytes).find("unexpected end of input"), std::string::npos);
  EXPECT_EQ(refusal_from_pipe(kMaxFileBytes + 1), ": holds more than the allowed 64 MiB");
}

}  // namespace
}  // namespace torquewright::io
