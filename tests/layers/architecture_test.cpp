// SPDX-License-Identifier: Apache-2.0
// docs/architecture.md is what the table of layers and the sources say. Oracle: these. Written anew
// by `layers_test --gtest_also_run_disabled_tests --gtest_filter=*Architecture.IsWritten`.
#include "tests/layers/architecture.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace torquewright::layers {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = TORQUEWRIGHT_SOURCE_DIR;
const fs::path kPage = kRoot / "docs" / "architecture.md";
const fs::path kPicture = kRoot / "docs" / "pictures" / "architecture.svg";
constexpr char kBegin[] = "<!-- from the table of layers -->\n";
constexpr char kEnd[] = "<!-- to here -->\n";

std::string whole_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Architecture, IsWhatTheLayersSay) {
  // Not printed whole: it is long.
  EXPECT_TRUE(whole_text(kPage).find(kBegin + architecture_tables(kRoot) + kEnd) !=
              std::string::npos)
      << "docs/architecture.md is stale; the head of this file says how it is written anew";
  EXPECT_TRUE(whole_text(kPicture) == architecture_picture());
}

TEST(DISABLED_Architecture, IsWritten) {
  std::string page = whole_text(kPage);
  const std::size_t begin = page.find(kBegin) + std::size(kBegin) - 1;
  page.replace(begin, page.find(kEnd) - begin, architecture_tables(kRoot));
  std::ofstream(kPage, std::ios::binary) << page;
  std::ofstream(kPicture, std::ios::binary) << architecture_picture();
}

}  // namespace
}  // namespace torquewright::layers
