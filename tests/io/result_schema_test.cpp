// SPDX-License-Identifier: Apache-2.0
// The shape of results: a result from the corpus of broken and whole documents, and slips in it.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/documents/document.hpp"
#include "io/files/file_bytes.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

json whole_result() {
  const auto file =
      std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/fuzz/corpus/result.json";
  return json::parse(read_file_bytes(file));
}

/// What the result is refused with once the value at the pointer is another.
std::string refusal_with(const char* pointer, const json& value) {
  json result = whole_result();
  result[json::json_pointer(pointer)] = value;
  try {
    check_document(result, "gearbox_result", "r", "");
    return "";
  } catch (const SpecError& error) {
    return error.what();
  }
}

TEST(GearboxResult, IsAcceptedWhole) { EXPECT_EQ(refusal_with("/version", 1), ""); }

TEST(GearboxResult, HoldsItsProblem) {
  EXPECT_EQ(refusal_with("/problem/target_ratio", 0.5),
            "r#/problem/target_ratio: 0.5 is outside [1, 10000]");
  EXPECT_EQ(refusal_with("/problem/kind", "gearbox"),
            "r#/problem/kind: \"gearbox\" is not \"gearbox_problem\"");
}

TEST(GearboxResult, HasTreesOfNodes) {
  const std::string nodes = "/certificate/claims/0/alternatives/0/nodes";
  EXPECT_EQ(refusal_with((nodes + "/1").c_str(), json::object()),
            "r#" + nodes + "/1: must hold \"split\" or \"closed\"");
  EXPECT_EQ(refusal_with((nodes + "/1/closed").c_str(), "shut"),
            "r#" + nodes +
                "/1/closed: \"shut\" is not one of \"empty\", \"enumerated\", "
                "\"relaxation\", \"open\"");
  EXPECT_EQ(refusal_with((nodes + "/0/cuts/0").c_str(), {"ratio", "moon", "max"}),
            "r#" + nodes +
                "/0/cuts/0: holds 3 values, must hold at least 4 values\n"
                "r#" +
                nodes +
                "/0/cuts/0/1: \"moon\" is not one of \"sun\", \"planet_1\", "
                "\"difference\", \"planet\"");
  EXPECT_EQ(refusal_with((nodes + "/0/split/1").c_str(), 1.5),
            "r#" + nodes + "/0/split/1: 1.5 is not whole, must be a whole number");
  EXPECT_EQ(refusal_with((nodes + "/2/multipliers/ratio_min").c_str(), -1),
            "r#" + nodes + "/2/multipliers/ratio_min: -1 is less than 0");
}

TEST(GearboxResult, SaysNullWhereThereIsNothing) {
  EXPECT_EQ(refusal_with("/objective", "none"),
            "r#/objective: is a string, must be a number or null");
  EXPECT_EQ(refusal_with("/conflict/0/without_it", 3),
            "r#/conflict/0/without_it: is a number, must be null or an object");
  EXPECT_EQ(refusal_with("/certificate/claims/0/reference", {{"teeth", {{"sun", 1}}}}),
            "r#/certificate/claims/0/reference/planet_count: missing\n"
            "r#/certificate/claims/0/reference/module_mm: missing");
}

}  // namespace
}  // namespace torquewright::io
