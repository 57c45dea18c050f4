// SPDX-License-Identifier: Apache-2.0
// No file includes itself by way of others: then every room can be read from the bottom to the top.
#include "tests/layers/circles.hpp"

#include <gtest/gtest.h>

namespace torquewright::layers {
namespace {

TEST(Sources, IncludeEachOtherInNoCircle) {
  for (const std::string& file : files_in_circles(library_sources(TORQUEWRIGHT_SOURCE_DIR))) {
    ADD_FAILURE() << file << " is part of a circle of includes, or lies between two";
  }
}

// Oracle: graphs by hand. top -> a -> b -> a, b -> bottom: only a and b go round.
TEST(FilesInCircles, AreThoseThatComeBackToThemselves) {
  const std::vector<SourceFile> sources{
      {"io/top.cpp", {{"io/a.hpp"}}},    {"io/a.hpp", {{"vector", false}}},
      {"io/a.cpp", {{"io/b.hpp"}}},      {"io/b.hpp", {{"io/a.hpp"}, {"io/bottom.hpp"}}},
      {"io/bottom.hpp", {{"a", false}}}, {"io/bottom.cpp", {{"io/bottom.hpp"}}}};
  EXPECT_EQ(files_in_circles(sources), (std::set<std::string>{"io/a", "io/b"}));
}

TEST(FilesInCircles, AreNoneWhereEverythingPointsDownward) {
  EXPECT_TRUE(files_in_circles({{"io/a.cpp", {{"io/a.hpp"}, {"io/b.hpp"}}},
                                {"io/a.hpp", {{"io/b.hpp"}}},
                                {"io/b.cpp", {{"io/b.hpp"}}}})
                  .empty());
}

}  // namespace
}  // namespace torquewright::layers
