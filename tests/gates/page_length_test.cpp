// SPDX-License-Identifier: Apache-2.0
// Pages are read, so they are short: no paragraph fills a screen, and docs/ does not grow for ever.
// Oracle: the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestParagraph = 800;  ///< Characters; a choice of ours: some ten lines.
/// Words of docs/, as of the last time that all of it was shortened, to the next thousand.
constexpr std::ptrdiff_t kMostWords = 102'300;

struct Paragraph {
  std::size_t line = 0;  ///< Where it begins, counted from 1.
  std::string text;
};

/// Characters of UTF-8, not bytes.
std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
  }));
}

bool begins_an_item(const std::string& line) {
  if (line.starts_with("* ") || line.starts_with("- ") || line.starts_with("> ")) return true;
  const std::size_t end = line.find_first_not_of("0123456789");
  return end != 0 && end != std::string::npos && line.compare(end, 2, ". ") == 0;
}

/// Whether a line is neither prose nor blank: a heading, a row of a table, a picture, a mark, or an
/// indented block (commands and their output, formulas, what is nested in a list).
bool is_no_prose(const std::string& line) {
  return std::string(" \t#|!<").find(line[0]) != std::string::npos;
}

/// Runs of plain lines of a page; each item of a list is one. Blocks of code are left out.
std::vector<Paragraph> paragraphs_of(const std::string& page) {
  std::istringstream lines(page);
  std::vector<Paragraph> paragraphs;
  bool is_code = false;
  bool goes_on = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool is_fence = line.starts_with("```");
    if (is_fence) is_code = !is_code;
    if (is_fence || is_code || line.empty() || is_no_prose(line)) {
      goes_on = false;
      continue;
    }
    if (!goes_on || begins_an_item(line)) {
      paragraphs.push_back({number, line});
    } else {
      paragraphs.back().text += " " + line;
    }
    goes_on = true;
  }
  return paragraphs;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> all = files_in("docs", ".md");
  all.insert(all.end(), {"README.md", "CONTRIBUTING.md"});
  return all;
}

TEST(Pages, HaveNoLongParagraph) {
  std::size_t looked_at = 0;
  for (const fs::path& page : pages()) {
    for (const Paragraph& paragraph : paragraphs_of(text_of(page))) {
      EXPECT_LE(length_of(paragraph.text), kLongestParagraph)
          << page.generic_string() << ":" << paragraph.line << ": a paragraph of "
          << length_of(paragraph.text) << " characters: say it shorter, or split it";
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 1000u);
}

// docs/documents is written by `schema --markdown` and grows with the schemas' keys.
TEST(Pages, HoldNoMoreWordsThanTheyMay) {
  std::ptrdiff_t words = 0;
  for (const fs::path& page : files_in("docs", ".md")) {
    if (page.parent_path() == "docs/documents") continue;
    std::istringstream stream(text_of(page));
    words += std::distance(std::istream_iterator<std::string>(stream), {});
  }
  EXPECT_LE(words, kMostWords)
      << "docs/ has too many words: say once what stands twice and link to it, take out what is "
      << "only history, move long tables of results to bench/; only where every word is needed "
      << "raise kMostWords in " << __FILE__;
  EXPECT_GT(words, kMostWords - 10'000) << "lower kMostWords in " << __FILE__;
}

TEST(Paragraphs, AreRunsOfPlainLines) {
  const auto found = paragraphs_of(
      "# Title\none\ntwo\n\n    code\nthree\n| cell |\n```\nfenced\n```\n* item\n  nested\n"
      "1. first\n12. second\ngoes on\n3.5 is no item\n");
  std::vector<std::string> texts;
  std::vector<std::size_t> lines;
  for (const Paragraph& paragraph : found) {
    texts.push_back(paragraph.text);
    lines.push_back(paragraph.line);
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"one two", "three", "* item", "1. first",
                                             "12. second goes on 3.5 is no item"}));
  EXPECT_EQ(lines, (std::vector<std::size_t>{2, 6, 11, 13, 14}));
}

TEST(Paragraphs, AreMeasuredInCharacters) { EXPECT_EQ(length_of("10 µm → ±"), 9u); }

}  // namespace
}  // namespace torquewright::gates
