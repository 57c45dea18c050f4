// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"
#include "io/file_session.hpp"
#include "src/command_line/exit_status.hpp"
#include "src/program.hpp"

int main(int argc, char** argv) {
  torquewright::io::ignore_file_size_signal();
  const torquewright::io::FileSession session;
  return torquewright::command_line::exit_status(
      [&] { return torquewright::cli::run_program(argc, argv); });
}
