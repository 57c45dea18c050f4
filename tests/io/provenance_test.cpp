// SPDX-License-Identifier: Apache-2.0
#include "io/documents/provenance.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <vector>

#include "io/documents/document.hpp"

namespace torquewright::io {
namespace {

TEST(Provenance, NamesToolVersionAndInputs) {
  EXPECT_TRUE(
      std::regex_match(std::string(tool_version()), std::regex("[0-9]+[.][0-9]+[.][0-9]+")));
  EXPECT_EQ(tool_provenance().dump(),
            "{\"name\":\"torquewright\",\"version\":\"" + std::string(tool_version()) + "\"}");
  const std::vector<Document> documents = {{"b.json", "", nullptr, "12"},
                                           {"a.json", "", nullptr, "34"}};
  EXPECT_EQ(input_provenance(documents).dump(),
            R"([{"path":"b.json","sha256":"12"},{"path":"a.json","sha256":"34"}])");
}

}  // namespace
}  // namespace torquewright::io
