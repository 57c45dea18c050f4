// SPDX-License-Identifier: Apache-2.0
#include "tests/gates/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace torquewright::gates {

namespace fs = std::filesystem;

fs::path root() { return TORQUEWRIGHT_SOURCE_DIR; }

std::string text_of(const fs::path& name) {
  std::ifstream stream(root() / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(root() / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) {
    if (entry.path().extension() != extension) continue;
    files.push_back(entry.path().lexically_relative(root()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

Names matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern, std::regex::ECMAScript | std::regex::multiline);
  Names names;
  for (std::sregex_iterator found(text.begin(), text.end(), expression), end; found != end;
       ++found) {
    names.insert((*found)[1].str());
  }
  return names;
}

std::string section(const std::string& page, const std::string& heading) {
  const std::size_t begin = page.find("\n" + heading);
  if (begin == std::string::npos) return "";
  return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

Names named_in_first_column(const std::string& page) {
  static const std::regex kName("`([^`]+)`");
  Names names;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `") && !line.starts_with("| [`")) continue;
    const std::string cell = line.substr(1, line.find(" | ", 2));
    std::string before;
    for (std::sregex_iterator found(cell.begin(), cell.end(), kName), end; found != end; ++found) {
      std::string name = (*found)[1].str();
      if (name.starts_with('.')) name = before.substr(0, before.rfind('.')) + name;
      names.insert(name);
      before = name;
    }
  }
  return names;
}

}  // namespace torquewright::gates
