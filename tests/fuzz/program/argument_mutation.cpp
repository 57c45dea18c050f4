// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/argument_mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tests/fuzz/program/chance.hpp"
#include "tests/fuzz/program/example_commands.hpp"

namespace torquewright::fuzz {
namespace {

const std::vector<std::string> kNumbers{"nan",
                                        "-nan",
                                        "inf",
                                        "-inf",
                                        "1e308",
                                        "-1e308",
                                        "1.8e308",
                                        "1e400",
                                        "1e-310",
                                        "-1e-310",
                                        "0",
                                        "-0",
                                        "-1",
                                        "1",
                                        "2",
                                        "0.5",
                                        "1e9",
                                        "1e-9",
                                        "1000000",
                                        "2147483648",
                                        "-2147483649",
                                        "9223372036854775808",
                                        "18446744073709551616",
                                        "0x10",
                                        "1,5",
                                        "1.",
                                        ".5",
                                        "1e",
                                        "+1",
                                        "1e3"};

const std::vector<std::string> kTexts{"",
                                      " ",
                                      "-",
                                      "--",
                                      ",",
                                      ":",
                                      "=",
                                      "@",
                                      ",,,",
                                      "a=",
                                      "=a",
                                      "a=b=c",
                                      "\xFF",
                                      "\xEF\xBF\xBE",
                                      "\n",
                                      "a\nb",
                                      "\"",
                                      "'",
                                      "$(x)",
                                      "%s%n",
                                      "\\",
                                      "..",
                                      "/",
                                      "/dev/null",
                                      "absent",
                                      "specs",
                                      "json",
                                      "csv",
                                      "motor",
                                      "joint",
                                      "knee",
                                      "ankle_pitch",
                                      "/bodies/0/mass_kg",
                                      "/bodies/-",
                                      "/",
                                      "~2",
                                      "<a>&amp;",
                                      "\xC2\xB0"
                                      "C"};

std::string very_many(Random& random) {
  const std::vector<std::string> units{"1,", "a", "1:2,", "/", "-", "x=1,"};
  const std::string unit = one_of(units, random);
  std::string text;
  for (std::size_t count = 1 + one_below(3000, random); count > 0; --count) text += unit;
  return text;
}

/// A number near the one that stands there, or any.
std::string other_number(const std::string& part, Random& random) {
  const std::vector<double> factors{0.0, -1.0, 0.5, 2.0, 10.0, 1e3, 1e6, 1e-3, 1e-9, 1.0 + 1e-9};
  char* end = nullptr;
  const double number = std::strtod(part.c_str(), &end);
  if (part.empty() || *end != '\0' || once_in(2, random)) return one_of(kNumbers, random);
  return fmt::format("{}", number * one_of(factors, random));
}

/// One of the parts between , : = @ replaced.
std::string with_other_part(const std::string& value, Random& random) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (std::string(",:=@*").find(value[i]) != std::string::npos) starts.push_back(i + 1);
  }
  const std::size_t start = one_of(starts, random);
  const std::size_t end = std::min(value.find_first_of(",:=@*", start), value.size());
  const std::string part = once_in(5, random)
                               ? one_of(kTexts, random)
                               : other_number(value.substr(start, end - start), random);
  return value.substr(0, start) + part + value.substr(end);
}

/// Where the command's own name ends.
std::size_t first_argument(const Words& arguments) {
  std::size_t at = 0;
  while (at < arguments.size() && at < 2 && arguments[at].find_first_of("-./") != 0 &&
         arguments[at].find('.') == std::string::npos) {
    ++at;
  }
  return at;
}

/// Some word behind the command's name, or none.
Words::iterator any_word(Words& words, Random& random) {
  const std::size_t first = first_argument(words);
  if (words.size() <= first) return words.end();
  return words.begin() + static_cast<long>(first + one_below(words.size() - first, random));
}

void change_value(Words& words, Random& random) {
  const auto word = any_word(words, random);
  if (word == words.end()) return;
  // An option's name is kept three times out of four, and what follows it is changed.
  const bool moves_on = word->starts_with("-") && !once_in(4, random) && word + 1 != words.end();
  std::string& value = moves_on ? *(word + 1) : *word;
  value = nasty_value(value, random);
}

void drop(Words& words, Random& random) {
  const auto word = any_word(words, random);
  if (word != words.end()) words.erase(word);
}

void repeat(Words& words, Random& random) {
  const auto word = any_word(words, random);
  if (word == words.end()) return;
  const auto end = std::min(word + static_cast<long>(1 + one_below(3, random)), words.end());
  const Words piece(word, end);
  words.insert(words.end(), piece.begin(), piece.end());
}

void swap_words(Words& words, Random& random) {
  const auto one = any_word(words, random), other = any_word(words, random);
  if (one != words.end()) std::iter_swap(one, other);
}

/// One of its choices, or a value that some example gives to that option, or a number.
std::string value_for(const DeclaredOption& option, Random& random) {
  Words values = option.choices;
  for (const Words& command : example_commands()) {
    for (std::size_t i = 0; i + 1 < command.size(); ++i) {
      if (command[i] == option.name) values.push_back(command[i + 1]);
    }
  }
  if (values.empty() || once_in(4, random)) return one_of(kNumbers, random);
  const std::string& value = one_of(values, random);
  return once_in(5, random) ? nasty_value(value, random) : value;
}

/// An option of the command, or of another once in ten times.
void add_option(Words& words, const std::vector<DeclaredCommand>& vocabulary, Random& random) {
  const DeclaredCommand* command = &one_of(vocabulary, random);
  const bool is_any = once_in(10, random);
  for (const DeclaredCommand& each : vocabulary) {
    const bool is_it = each.name.size() <= words.size() &&
                       std::equal(each.name.begin(), each.name.end(), words.begin());
    if (is_it && !is_any) command = &each;
  }
  if (command->options.empty()) return;
  const DeclaredOption& option = one_of(command->options, random);
  words.push_back(option.name);
  if (option.has_value) words.push_back(value_for(option, random));
}

void change_file(Words& words, const std::vector<std::string>& files, Random& random) {
  const auto word = any_word(words, random);
  if (word == words.end() || word->find('.') == std::string::npos) return;
  const std::size_t equals = word->find('=');
  const std::string start = equals == std::string::npos ? "" : word->substr(0, equals + 1);
  *word = start + one_of(files, random);
}

}  // namespace

std::string nasty_value(const std::string& value, Random& random) {
  switch (one_below(8, random)) {
    case 0:
      return one_of(kTexts, random);
    case 1:
      return value + one_of(kTexts, random);
    case 2:
      return value + "," + one_of(kNumbers, random);
    case 3:
      return once_in(4, random) ? very_many(random) : one_of(kNumbers, random);
    case 4:
      return one_of(kNumbers, random);
    default:
      return with_other_part(value, random);
  }
}

void change_arguments(Words& arguments, const std::vector<DeclaredCommand>& vocabulary,
                      const std::vector<std::string>& files, Random& random) {
  switch (one_below(10, random)) {
    case 0:
      return drop(arguments, random);
    case 1:
      return repeat(arguments, random);
    case 2:
      return swap_words(arguments, random);
    case 3:
      return change_file(arguments, files, random);
    case 4:
    case 5:
    case 6:
      return add_option(arguments, vocabulary, random);
    default:
      return change_value(arguments, random);
  }
}

}  // namespace torquewright::fuzz
