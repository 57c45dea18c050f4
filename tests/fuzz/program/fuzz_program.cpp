// SPDX-License-Identifier: Apache-2.0
// Runs the built program with changed arguments, documents, logs and outputs, and holds every run
// against rules (rules.cpp): see bench/README.md.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/fuzz/program/campaign.hpp"

namespace {

/// Set where the program is built with sanitizers, which slow it down.
double default_patience() {
  const char* text = std::getenv("TORQUEWRIGHT_FUZZ_PATIENCE");
  return text == nullptr ? 1.0 : std::strtod(text, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace torquewright;
  fuzz::Plan plan;
  plan.program = TORQUEWRIGHT_PROGRAM;
  plan.patience = default_patience();
  bool copies = false;
  std::string program = plan.program.string(), findings, one;
  command_line::Program line("fuzz_program", "Runs torquewright with changed inputs and options");
  command_line::Command& top = line.top();
  top.add_option("--program", program, "Another build of it").existing_file();
  top.add_option("--seed", plan.seed, "Of the cases");
  top.add_option("--first", plan.first, "Number of the first case");
  top.add_option("--runs", plan.runs, "So many cases");
  top.add_option("--seconds", plan.seconds, "Until so many are over");
  top.add_option("--patience", plan.patience, "Times the limits of time and memory").positive();
  top.add_option("--findings", findings, "Folder for what breaks a rule");
  top.add_option("--most-findings", plan.most_findings, "Ends after so many");
  top.add_option("--without", plan.without, "Leaves out command lines that begin so");
  top.add_flag("--copies", copies, "Load the libraries once; runs are copies of that process");
  top.add_option("--case", one, "Only that of this file").existing_file();
  top.works([&] {
    plan.program = std::filesystem::absolute(program);
    plan.findings = findings;
    if (copies) plan.copies = TORQUEWRIGHT_FORK_SERVER;
    const int found = one.empty() ? fuzz::run_campaign(plan) : fuzz::repeat_case(plan, one);
    return found == 0 ? cli::ExitCode::kPasses : cli::ExitCode::kFails;
  });
  return command_line::exit_status([&] { return line.run(argc, argv); });
}
