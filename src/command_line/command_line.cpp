// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <type_traits>
#include <utility>

#include "io/documents/read_notes.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/print.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"
#include "src/command_line/blank_value.hpp"
#include "src/command_line/help_text.hpp"
#include "src/command_line/misspelling.hpp"
#include "src/command_line/repeated_option.hpp"
#include "src/loudness.hpp"

namespace torquewright::command_line {
namespace {

/// Bounds so far out that they only keep out what is no quantity at all.
constexpr double kFarOut = 1e9;

/// "a number from 0 to 1", for refusals to the last digit.
std::string range_in_words(const std::string& what, const std::string& least,
                           const std::string& greatest) {
  return fmt::format("{} from {} to {}", what, least, greatest);
}

/// The same for the help, which leaves out what is far out.
std::string range_in_help(const std::string& what, double least, double greatest) {
  if (least <= -kFarOut && greatest >= kFarOut) return what;
  if (greatest >= kFarOut) return fmt::format("{} of {} or more", what, least);
  if (least <= -kFarOut) return fmt::format("{} of {} or less", what, greatest);
  return range_in_words(what, fmt::format("{}", least), fmt::format("{}", greatest));
}

/// 044 is octal to the library that converts it, and so 36.
bool has_idle_zero(const std::string& text) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  return text.size() > first + 1 && text[first] == '0';
}

template <typename Number>
std::optional<Number> whole_number(const std::string& text) {
  if (has_idle_zero(text)) return std::nullopt;
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// No quantity is "nan" or "inf", and every comparison lets "nan" pass. Nor is it hexadecimal, as
/// no document's number is.
std::optional<double> finite_number(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool is_decimal = text.find_first_of("xX") == std::string::npos;
  if (text.empty() || !is_decimal || *end != '\0' || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// What a value must be, with the words that say so.
template <typename Accepts>
CLI::Validator must_be(const std::string& what, Accepts accepts) {
  return CLI::Validator(
      [what, accepts](const std::string& text) {
        return accepts(text) ? std::string() : fmt::format("\"{}\" is not {}", text, what);
      },
      "");
}

const CLI::Validator kFinite = must_be(
    "a finite number", [](const std::string& text) { return finite_number(text).has_value(); });

template <typename Number>
CLI::Validator whole() {
  return must_be("a whole number",
                 [](const std::string& text) { return whole_number<Number>(text).has_value(); });
}

/// An unset variable of a script leaves "", which would count as if nothing were said.
const CLI::Validator kNotEmpty(
    [](const std::string& text) {
      return text.empty() ? std::string("\"\" is blank") : std::string();
    },
    "");

const CLI::Validator kNamed(
    [](const std::string& file) {
      return file.empty() ? std::string("a file's name is missing") : std::string();
    },
    "");

std::string not_among(const std::string& word, const std::vector<std::string>& words) {
  const auto near = io::nearest(word, words);
  return fmt::format("\"{}\" is not one of {}{}", word, io::listed(words),
                     near ? fmt::format("; did you mean {}?", *near) : "");
}

/// "-o,--output" as its parts; "!--no-check" is shown as it is typed.
std::vector<std::string> parts_of(const std::string& names) {
  std::vector<std::string> parts;
  std::istringstream stream(names);
  for (std::string part; std::getline(stream, part, ',');) {
    parts.push_back(part.starts_with('!') ? part.substr(1) : part);
  }
  return parts;
}

/// The inner command works in the outer one's place, and gets nothing of what stands before it.
void require_nothing_before(const CLI::App& app, const DeclaredCommand& outer,
                            const std::string& inner) {
  const std::deque<DeclaredOption>& taken = find_command(outer, inner)->options;
  for (const DeclaredOption& option : outer.options) {
    const std::string& name = longest_name(option);
    const CLI::Option* given = app.get_option_no_throw(name);
    if (given == nullptr || given->count() == 0) continue;
    const std::string value = given->results().front();
    const std::string words = option.is_argument     ? fmt::format("\"{}\"", value)
                              : option.value.empty() ? name
                                                     : fmt::format("{} {}", name, value);
    const bool is_taken = std::any_of(taken.begin(), taken.end(), [&](const DeclaredOption& other) {
      return longest_name(other) == name;
    });
    refuse(fmt::format("{0} stands before {1}, {2}", words, inner,
                       is_taken ? "which would not get it; write it behind " + inner
                                : "which takes no such thing"));
  }
}

DeclaredOption declared_option(const std::vector<std::string>& names, const std::string& value,
                               const std::string& help) {
  DeclaredOption option;
  option.names = names;
  option.value = value;
  option.help = help;
  option.is_argument = !names.front().starts_with('-');
  return option;
}

/// The value at declaration as the help has it; of a list or a flag none.
template <typename Value>
std::string default_in_help(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return "";
  } else {
    return fmt::format("{}", value);
  }
}
template <typename Value>
std::string default_in_help(const std::vector<Value>&) {
  return "";
}
std::string default_in_help(const std::optional<double>& value) {
  return value ? default_in_help(*value) : "";
}

template <typename Value>
OptionValue value_of(const Value& value) {
  if constexpr (std::is_same_v<Value, int>) {
    return std::int64_t{value};
  } else {
    return value;
  }
}
OptionValue value_of(const std::optional<double>& value) {
  return value ? OptionValue(*value) : OptionValue();
}

}  // namespace

Option Option::required() {
  option_->required();
  declared_->is_required = true;
  declared_->otherwise.clear();
  return *this;
}

Option Option::needed_by_its_work() {
  declared_->is_required = true;
  declared_->otherwise.clear();
  return *this;
}

Option Option::one_value_each() {
  option_->allow_extra_args(false);
  declared_->is_repeated = true;
  return *this;
}

Option Option::separated_by_commas() {
  option_->delimiter(',');
  declared_->has_commas = true;
  return *this;
}

Option Option::takes(int values) {
  option_->expected(values);
  declared_->is_list = values > 1;
  return *this;
}

Option Option::otherwise(const std::string& what) {
  declared_->otherwise = what;
  is_default_said_ = true;
  return *this;
}

/// The range's check refuses what is no number too, and says more.
void Option::says_more_than_its_kind() { option_->get_validator(0)->active(false); }

void Option::drop_default_unless(bool is_allowed) {
  if (!is_allowed && !is_default_said_) declared_->otherwise.clear();
}

Option Option::between(double least, double greatest) {
  says_more_than_its_kind();
  const auto is_inside = [least, greatest](const std::string& text) {
    const auto number = finite_number(text);
    return number && *number >= least && *number <= greatest;
  };
  option_->check(
      must_be(range_in_words("a number", fmt::format("{}", least), fmt::format("{}", greatest)),
              is_inside));
  declared_->range = range_in_help("a number", least, greatest);
  drop_default_unless(is_inside(declared_->otherwise));
  return *this;
}

Option Option::integer_between(std::int64_t least, std::int64_t greatest) {
  says_more_than_its_kind();
  const auto is_inside = [least, greatest](const std::string& text) {
    const auto number = whole_number<std::int64_t>(text);
    return number && *number >= least && *number <= greatest;
  };
  option_->check(
      must_be(range_in_words("a whole number", std::to_string(least), std::to_string(greatest)),
              is_inside));
  declared_->range =
      range_in_help("a whole number", static_cast<double>(least), static_cast<double>(greatest));
  drop_default_unless(is_inside(declared_->otherwise));
  return *this;
}

Option Option::positive() {
  says_more_than_its_kind();
  option_->check(must_be("a number above 0", [](const std::string& text) {
    const auto number = finite_number(text);
    return number && *number > 0.0;
  }));
  declared_->range = "a number above 0";
  return *this;
}

Option Option::one_of(const std::vector<std::string>& words) {
  says_more_than_its_kind();
  const auto is_among = [words](const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  option_->check(CLI::Validator(
      [words, is_among](const std::string& word) {
        return is_among(word) ? std::string() : not_among(word, words);
      },
      ""));
  declared_->value = "WORD";
  declared_->choices = words;
  drop_default_unless(is_among(declared_->otherwise));
  return *this;
}

Option Option::offers(const std::vector<std::string>& words) {
  declared_->choices = words;
  return *this;
}

Option Option::existing_file() {
  says_more_than_its_kind();
  option_->check(CLI::ExistingFile);
  declared_->value = "FILE";
  return *this;
}

Option Option::names_a_file() {
  says_more_than_its_kind();
  option_->check(kNamed);
  declared_->value = "FILE";
  declared_->writes_file = true;
  return *this;
}

Option Option::not_standard_output() {
  option_->check(must_be("a file but standard output, which cannot hold this",
                         [](const std::string& file) { return file != "-"; }));
  declared_->is_never_printed = true;
  return *this;
}

Option Option::excludes(const std::string& other) {
  option_->excludes(other);
  declared_->excludes.push_back(other);
  return *this;
}

Option Option::needs(const std::string& other) {
  option_->needs(other);
  declared_->needs.push_back(other);
  return *this;
}

Option Option::echoed(const OptionEcho& echo) {
  declared_->echo = echo;
  return *this;
}

Option Option::stated_as(const std::string& key, int place) {
  return echoed({key, OptionEcho::When::kUnlessUsual, place});
}

Option Option::stated_as_not(const std::string& key, int place) {
  return echoed({key, OptionEcho::When::kUnlessUsual, place, true});
}

Option Option::always_stated_as(const std::string& key, int place) {
  return echoed({key, OptionEcho::When::kAlways, place});
}

Option Option::stated_elsewhere_as(const std::string& key, int place) {
  return echoed({key, OptionEcho::When::kElsewhere, place});
}

Option Option::of_one_answer() {
  declared_->is_of_one = true;
  return *this;
}

template <typename Value>
Option Command::add(CLI::Option& option, const std::string& names, const Value& value,
                    const std::string& kind, const std::string& help, bool is_list) {
  DeclaredOption declared = declared_option(parts_of(names), kind, help);
  declared.otherwise = default_in_help(value);
  declared.is_list = is_list;
  declared.value_now = [&value] { return value_of(value); };
  declared.usual = value_of(value);
  return Option(option, declared_->options.emplace_back(std::move(declared)));
}

Option Command::add_option(const std::string& names, std::string& value, const std::string& help) {
  return add(*app_->add_option(names, value)->check(kNotEmpty), names, value, "TEXT", help);
}

Option Command::add_option(const std::string& names, double& value, const std::string& help) {
  return add(*app_->add_option(names, value)->check(kFinite), names, value, "NUMBER", help);
}

Option Command::add_option(const std::string& names, std::optional<double>& value,
                           const std::string& help) {
  return add(*app_->add_option(names, value)->check(kFinite), names, value, "NUMBER", help);
}

Option Command::add_option(const std::string& names, int& value, const std::string& help) {
  return add(*app_->add_option(names, value)->check(whole<int>()), names, value, "N", help);
}

Option Command::add_option(const std::string& names, std::int64_t& value, const std::string& help) {
  return add(*app_->add_option(names, value)->check(whole<std::int64_t>()), names, value, "N",
             help);
}

Option Command::add_option(const std::string& names, std::uint64_t& value,
                           const std::string& help) {
  return add(*app_->add_option(names, value)->check(whole<std::uint64_t>()), names, value, "N",
             help);
}

Option Command::add_option(const std::string& names, std::vector<std::string>& values,
                           const std::string& help) {
  return add(*app_->add_option(names, values)->check(kNotEmpty), names, values, "TEXT", help, true);
}

Option Command::add_option(const std::string& names, std::vector<double>& values,
                           const std::string& help) {
  return add(*app_->add_option(names, values)->check(kFinite), names, values, "NUMBER", help, true);
}

Option Command::add_option(const std::string& names, std::vector<std::int64_t>& values,
                           const std::string& help) {
  return add(*app_->add_option(names, values)->check(whole<std::int64_t>()), names, values, "N",
             help, true);
}

Option Command::add_flag(const std::string& names, bool& value, const std::string& help) {
  return add(*app_->add_flag(names, value), names, value, "", help);
}

Command Command::add_command(const std::string& name, const std::string& help) {
  DeclaredCommand& declared = declared_->commands.emplace_back();
  declared.name = name;
  declared.help = help;
  declared.options.push_back(declared_option({"-h", "--help"}, "", "Print this help"));
  return Command(*app_->add_subcommand(name), declared, *named_);
}

void Command::require_command() {
  app_->require_subcommand(1);
  declared_->needs_command = true;
}

void Command::example(const std::string& line) { declared_->example = line; }

void Command::works(Work work) {
  add_flag("-q,--quiet", cli::loudness().is_quiet,
           "Print the answer's first line alone, no progress and no notes");
  add_flag("-v,--verbose", cli::loudness().is_verbose,
           "Print also what is assumed and what one screen leaves out")
      .excludes("--quiet");
  app_->callback([app = app_, declared = declared_, named = named_, work = std::move(work)] {
    const std::vector<CLI::App*> inner = app->get_subcommands();
    if (inner.empty()) {
      named->push_back(work);
    } else {
      require_nothing_before(*app, *declared, inner.front()->get_name());
    }
  });
}

Program::Program(const std::string& name, const std::string& help, const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)),
      version_(version),
      top_(*app_, declared_, named_) {
  declared_.name = name;
  declared_.help = help;
  declared_.options.push_back(declared_option({"-h", "--help"}, "", "Print this help"));
  if (version.empty()) return;
  app_->set_version_flag("-V,--version", version);
  declared_.options.push_back(declared_option({"-V", "--version"}, "", "Print the version"));
}

Program::~Program() = default;

/// Prints what --help and --version ask for, and the help of a command that only leads to others
/// where nothing follows it. False: the arguments are wrong.
bool Program::is_answered(const std::vector<std::string>& words,
                          const std::exception& error) const {
  const Reached reached = reached_by(declared_, words);
  if (dynamic_cast<const CLI::CallForVersion*>(&error)) {
    io::print(version_ + "\n");
    return true;
  }
  const bool leads_on = reached.command->needs_command && reached.rest == words.size();
  const bool asks = dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr;
  if (!asks && (!leads_on || misspelling(declared_, words))) return false;
  io::print(help_text(*reached.command, reached.path));
  return true;
}

void Program::refuse_words(const std::vector<std::string>& words, const std::string& why) const {
  if (const auto misspelt = misspelling(declared_, words)) refuse(*misspelt);
  // CLI11 takes the next word for what "--option=" leaves empty.
  const bool is_left_empty = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.starts_with("--") && word.ends_with('=');
  });
  const auto blank = is_left_empty ? blank_value(declared_, words) : std::nullopt;
  if (blank) refuse(*blank);
  if (const auto repeated = repeated_option(declared_, words)) refuse(*repeated);
  const DeclaredCommand& command = *reached_by(declared_, words).command;
  for (const DeclaredOption& option : command.options) {
    if (why != longest_name(option) + " is required" || option.choices.empty()) continue;
    refuse(why + ": " + io::either(option.choices));
  }
  refuse(why);
}

cli::ExitCode Program::run(int argc, const char* const* argv) {
  cli::loudness() = {};  // inside another program this may not be the first run
  const std::vector<std::string> words(argv + 1, argv + argc);
  const Reached leads = reached_by(declared_, words);
  if (leads.rest + 1 == words.size() && words.back() == "help" && leads.command->needs_command) {
    io::print(help_text(*leads.command, leads.path));
    return cli::ExitCode::kPasses;
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const Reached reached = reached_by(declared_, words);
    refuse_words(words,
                 fmt::format("{}; it is {}", error.what(), usage(*reached.command, reached.path)));
  } catch (const CLI::ParseError& error) {
    if (!is_answered(words, error)) refuse_words(words, error.what());
    return cli::ExitCode::kPasses;
  }
  if (const auto blank = blank_value(declared_, words)) refuse(*blank);
  if (cli::loudness().is_verbose) io::keep_read_notes();
  cli::ExitCode code = cli::ExitCode::kPasses;
  for (const Work& work : named_) code = work();
  return code;
}

void refuse(const std::string& why) {
  throw io::SpecError({{"command line", "", why + "; --help shows what is allowed"}});
}

}  // namespace torquewright::command_line
