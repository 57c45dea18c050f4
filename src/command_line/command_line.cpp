// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>

#include "io/spec_error.hpp"

namespace torquewright::command_line {
namespace {

/// No quantity is "nan" or "inf", and every comparison lets "nan" pass.
const CLI::Validator kFinite(
    [](const std::string& text) {
      return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : text + " is no finite number";
    },
    "");

const CLI::Validator kNamed(
    [](const std::string& file) {
      return file.empty() ? std::string("a file's name is missing") : std::string();
    },
    "");

}  // namespace

Option Option::required() { return Option(*option_->required()); }

Option Option::one_value_each() { return Option(*option_->allow_extra_args(false)); }

Option Option::separated_by_commas() { return Option(*option_->delimiter(',')); }

Option Option::takes(int values) { return Option(*option_->expected(values)); }

Option Option::shows_default() { return Option(*option_->capture_default_str()); }

Option Option::between(double least, double greatest) {
  return Option(*option_->check(CLI::Range(least, greatest)));
}

Option Option::integer_between(std::int64_t least, std::int64_t greatest) {
  return Option(*option_->check(CLI::Range(least, greatest)));
}

Option Option::positive() { return Option(*option_->check(CLI::PositiveNumber)); }

Option Option::one_of(const std::vector<std::string>& words) {
  return Option(*option_->check(CLI::IsMember(words)));
}

Option Option::existing_file() { return Option(*option_->check(CLI::ExistingFile)); }

Option Option::names_a_file() { return Option(*option_->check(kNamed)); }

Option Option::excludes(const std::string& other) { return Option(*option_->excludes(other)); }

Option Option::needs(const std::string& other) { return Option(*option_->needs(other)); }

Option Command::add_option(const std::string& names, std::string& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, double& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help)->check(kFinite));
}

Option Command::add_option(const std::string& names, std::optional<double>& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help)->check(kFinite));
}

Option Command::add_option(const std::string& names, int& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::int64_t& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::uint64_t& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::vector<std::string>& values,
                           const std::string& help) {
  return Option(*app_->add_option(names, values, help));
}

Option Command::add_option(const std::string& names, std::vector<double>& values,
                           const std::string& help) {
  return Option(*app_->add_option(names, values, help)->check(kFinite));
}

Option Command::add_option(const std::string& names, std::vector<std::int64_t>& values,
                           const std::string& help) {
  return Option(*app_->add_option(names, values, help));
}

Option Command::add_flag(const std::string& names, bool& value, const std::string& help) {
  return Option(*app_->add_flag(names, value, help));
}

Command Command::add_command(const std::string& name, const std::string& help) {
  return Command(*app_->add_subcommand(name, help), *named_);
}

void Command::require_command() { app_->require_subcommand(1); }

void Command::example(const std::string& line) { app_->footer("Example:\n  " + line); }

void Command::works(Work work) {
  app_->callback([app = app_, named = named_, work = std::move(work)] {
    if (app->get_subcommands().empty()) named->push_back(work);
  });
}

Program::Program(const std::string& name, const std::string& help, const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)), top_(*app_, named_) {
  if (!version.empty()) app_->set_version_flag("--version", version);
}

Program::~Program() = default;

cli::ExitCode Program::run(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version come this way too, with exit code 0.
    if (error.get_exit_code() != 0) refuse(error.what());
    app_->exit(error);
    return cli::ExitCode::kPasses;
  }
  cli::ExitCode code = cli::ExitCode::kPasses;
  for (const Work& work : named_) code = work();
  return code;
}

void refuse(const std::string& why) {
  throw io::SpecError({{"command line", "", why + "; --help shows what is allowed"}});
}

}  // namespace torquewright::command_line
