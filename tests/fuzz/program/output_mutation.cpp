// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/output_mutation.hpp"

#include <algorithm>

#include "tests/fuzz/program/chance.hpp"
#include "tests/fuzz/program/command_files.hpp"

namespace torquewright::fuzz {
namespace {

/// Places of the values of options that name outputs.
std::vector<std::size_t> output_places(const Words& words) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (names_output(words[i])) places.push_back(i + 1);
  }
  return places;
}

void add_output(Words& words, const std::vector<DeclaredCommand>& vocabulary, Random& random) {
  std::vector<std::string> options;
  for (const DeclaredCommand& each : vocabulary) {
    const bool is_it = each.name.size() <= words.size() &&
                       std::equal(each.name.begin(), each.name.end(), words.begin());
    if (!is_it) continue;
    for (const DeclaredOption& option : each.options) {
      if (names_output(option.name)) options.push_back(option.name);
    }
  }
  const std::vector<std::string> names{"out.json", "out.csv", "out.svg", "out.png", "out"};
  if (options.empty()) return;
  words.push_back(one_of(options, random));
  words.push_back(one_of(names, random));
}

/// Words that name a file, without what stands before a "=".
Words files_in(const Words& words) {
  Words files;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && names_output(words[i - 1])) continue;
    const std::string file = words[i].substr(words[i].find('=') + 1);
    if (file.find('/') != std::string::npos && file.front() != '/') files.push_back(file);
  }
  return files;
}

std::string ending_of(const std::string& file) {
  const std::size_t point = file.rfind('.');
  return point == std::string::npos ? "" : file.substr(point);
}

/// Something of that kind in the way, under a name of its own with the same ending.
std::string in_the_way(Case& one, const Thing& thing, const std::string& ending) {
  const std::string name = "in_the_way" + ending;
  one.things[name] = thing;
  return name;
}

std::string other_output(Case& one, const std::string& file, Random& random) {
  const std::string ending = ending_of(file);
  const Words files = files_in(one.arguments);
  const std::string input = files.empty() ? "specs/actuator/d151_knee.json" : one_of(files, random);
  switch (one_below(14, random)) {
    case 0:
      return input;
    case 1:
      return "specs/../" + input;
    case 2:
      return in_the_way(one, {Thing::Kind::kHardLink, input}, ending);
    case 3:
      return in_the_way(one, {Thing::Kind::kLink, input}, ending);
    case 4:
      return in_the_way(one, {Thing::Kind::kLink, "absent" + ending}, ending);
    case 5:
      return in_the_way(one, {Thing::Kind::kPipe, ""}, ending);
    case 6:
      return in_the_way(one, {Thing::Kind::kFolder, ""}, ending);
    case 7:
      return in_the_way(one, {Thing::Kind::kReadOnlyFile, "old"}, ending);
    case 8:
      return in_the_way(one, {Thing::Kind::kFile, "old"}, ending);
    case 9:
      return "/dev/full";
    case 10:
      return "absent/" + file;
    case 11:
      return "specs/actuator/d151_knee.json";  // which another document may name
    case 12:
      return "out\xFF" + ending;
    default:
      return in_the_way(one, {Thing::Kind::kLink, "in_the_way" + ending}, ending);
  }
}

}  // namespace

void change_output(Case& one, const std::vector<DeclaredCommand>& vocabulary, Random& random) {
  if (output_places(one.arguments).empty() || once_in(3, random)) {
    add_output(one.arguments, vocabulary, random);
  }
  const std::vector<std::size_t> places = output_places(one.arguments);
  if (places.empty()) return;
  std::string& file = one.arguments[one_of(places, random)];
  if (places.size() > 1 && once_in(3, random)) {
    file = one.arguments[one_of(places, random)];
  } else {
    file = other_output(one, file, random);
  }
}

}  // namespace torquewright::fuzz
