// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include "io/atomic_file.hpp"
#include "io/file_session.hpp"
#include "src/command_line/exit_status.hpp"
#include "src/program.hpp"
#include "src/sweep/worker_channel.hpp"

int main(int argc, char** argv) {
  torquewright::io::ignore_file_size_signal();
  std::signal(SIGCHLD, SIG_DFL);  // or nobody could tell us how a process that we start ends
  torquewright::sweep::end_with_starter();
  const torquewright::io::FileSession session;
  return torquewright::command_line::exit_status(
      [&] { return torquewright::cli::run_program(argc, argv); });
}
