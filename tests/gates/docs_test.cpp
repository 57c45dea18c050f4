// SPDX-License-Identifier: Apache-2.0
// Every page of docs/ can be reached from its index, and no link leads nowhere. Oracle: the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;

bool is_file_of_ours(const std::string& target) {
  return target.find("://") == std::string::npos && !target.starts_with('#');
}

/// Where the links of a page lead, named from the root, without the place on the page.
Names links_of(const fs::path& page) {
  Names links;
  // In derivations, [..](t - t0) is a product.
  for (const std::string& target : matches(text_of(page), R"(\]\(([^) ]+)\))")) {
    if (!is_file_of_ours(target)) continue;
    const std::string file = target.substr(0, target.find('#'));
    links.insert((page.parent_path() / file).lexically_normal().generic_string());
  }
  return links;
}

void follow(const fs::path& page, Names& reached) {
  if (!reached.insert(page.generic_string()).second) return;
  for (const std::string& link : links_of(page)) {
    if (fs::path(link).extension() == ".md") follow(link, reached);
  }
}

TEST(Docs, AreReachedFromTheirIndex) {
  const Names direct = links_of("docs/README.md");
  for (const fs::path& page : files_in("docs", ".md")) {
    if (page == "docs/README.md") continue;
    const std::string index_of_folder = (page.parent_path() / "README.md").generic_string();
    const bool is_linked = direct.contains(page.generic_string()) ||
                           (direct.contains(index_of_folder) &&
                            links_of(index_of_folder).contains(page.generic_string()));
    EXPECT_TRUE(is_linked) << page << " is linked neither from docs/README.md nor from the README "
                           << "of its folder";
  }
}

TEST(Docs, HoldNoLinkThatLeadsNowhere) {
  Names pages;
  follow("README.md", pages);
  for (const fs::path& page : files_in("docs", ".md")) pages.insert(page.generic_string());
  for (const std::string& page : pages) {
    for (const std::string& link : links_of(page)) {
      EXPECT_TRUE(fs::exists(root() / link)) << page << " links to " << link;
    }
  }
}

/// Folders that a path may begin with to be one of the repository's.
constexpr std::string_view kNamedFolders[] = {
    "actuator/", "dynamics/",   "gearbox/", "hopper/", "io/",  "identification/",
    "robot/",    "simulation/", "scripts/", "specs/",  "src/", "tests/"};

// A path with a placeholder stands for a file that is to be written: its folder is there.
TEST(Contributing, NamesPathsThatAre) {
  int looked_at = 0;
  for (std::string name : matches(text_of("CONTRIBUTING.md"), "`([a-z_]+/[^` ]*)`")) {
    const bool is_ours = std::any_of(std::begin(kNamedFolders), std::end(kNamedFolders),
                                     [&](std::string_view one) { return name.starts_with(one); });
    if (!is_ours) continue;
    const std::string file = fs::path(name).filename().string();
    const bool is_to_be_written =
        file.starts_with("NAME") || file.starts_with("KIND") || file.find('*') != std::string::npos;
    if (is_to_be_written) name = fs::path(name).parent_path().generic_string();
    EXPECT_TRUE(fs::exists(root() / name)) << "CONTRIBUTING.md names " << name;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 40);
}

TEST(Docs, ShowEveryPicture) {
  Names shown = links_of("README.md");
  for (const fs::path& page : files_in("docs", ".md")) shown.merge(links_of(page));
  for (const char* ending : {".png", ".svg"}) {
    for (const fs::path& picture : files_in("docs/pictures", ending)) {
      EXPECT_TRUE(shown.contains(picture.generic_string())) << picture << " is on no page";
    }
  }
}

/// Every test of ours, Suite.Name.
Names tests_of_ours() {
  Names names;
  for (const fs::path& file : files_in("tests", ".cpp")) {
    for (std::string name : matches(text_of(file), R"(^TEST(?:_F|_P)?\((\w+,\s*\w+)\))")) {
      const std::size_t comma = name.find(',');
      const std::size_t second = name.find_first_not_of(", \n", comma);
      names.insert(name.replace(comma, second - comma, "."));
    }
  }
  return names;
}

TEST(Docs, NameTestsThatAre) {
  const Names there = tests_of_ours();
  const Names named = matches(text_of("docs/safety.md"), "`([A-Z]\\w*\\.[A-Z]\\w*)`");
  EXPECT_GT(named.size(), 50u);
  for (const std::string& name : named) EXPECT_TRUE(there.contains(name)) << name;
}

/// Of a page's prose: no commands and output, no tables, no headings.
std::vector<std::string> sentences_of(const std::string& page) {
  std::istringstream stream(page);
  std::string prose;
  for (std::string line; std::getline(stream, line);) {
    const bool is_prose = !line.empty() && std::string(" #|!").find(line[0]) == std::string::npos;
    prose += is_prose ? " " + line : ". ";
  }
  std::vector<std::string> sentences{""};
  for (std::size_t i = 0; i < prose.size(); ++i) {
    sentences.back() += prose[i];
    const bool ends = prose[i] == '.' || prose[i] == '?' || prose[i] == ':' || prose[i] == ';';
    if (ends && (i + 1 == prose.size() || prose[i + 1] == ' ')) sentences.emplace_back();
  }
  return sentences;
}

// Who reads it for the first time reads it once.
TEST(Readme, IsSaidInShortSentences) {
  for (const std::string& sentence : sentences_of(text_of("README.md"))) {
    std::istringstream words(sentence);
    const auto count = std::distance(std::istream_iterator<std::string>(words), {});
    EXPECT_LE(count, 30) << sentence;
  }
}

TEST(Readme, HasNoWordsOfTheHouse) {
  const std::string page = text_of("README.md");
  for (const std::string word : {" seed", "pitfall", "oracle"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
}

TEST(Readme, LeadsToTheIndex) { EXPECT_TRUE(links_of("README.md").contains("docs/README.md")); }

}  // namespace
}  // namespace torquewright::gates
