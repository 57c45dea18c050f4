// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "io/files/atomic_file.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/file_session.hpp"
#include "io/files/standard_descriptors.hpp"
#include "src/command_line/exit_status.hpp"
#include "src/exit_code.hpp"
#include "src/limited_stack.hpp"
#include "src/program.hpp"
#include "src/sweep/worker_channel.hpp"

int main(int argc, char** argv) {
  torquewright::io::fill_standard_descriptors();
  if (const std::string_view complaint = torquewright::cli::stack_complaint(); !complaint.empty()) {
    torquewright::io::write_all(STDERR_FILENO, complaint);
    return static_cast<int>(torquewright::cli::ExitCode::kBadInput);
  }
  torquewright::io::ignore_file_size_signal();
  std::signal(SIGCHLD, SIG_DFL);  // or nobody could tell us how a process that we start ends
  torquewright::sweep::end_with_starter();
  const torquewright::io::FileSession session;
  return torquewright::command_line::exit_status(
      [&] { return torquewright::cli::run_program(argc, argv); });
}
