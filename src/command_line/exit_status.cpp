// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/exit_status.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "io/faults/spec_error.hpp"
#include "io/files/file_session.hpp"

namespace torquewright::command_line {

namespace {

/// On standard error; where that leads into an input, which has to stay as it is, on standard
/// output, and nowhere where that does too.
void say(const std::string& sentence) {
  std::FILE* stream = stderr;
  try {
    if (io::is_input(STDERR_FILENO)) stream = io::is_input(STDOUT_FILENO) ? nullptr : stdout;
  } catch (const std::exception&) {  // no memory to look at what inputs name
    stream = stderr;
  }
  if (stream != nullptr) std::fprintf(stream, "%s\n", sentence.c_str());
}

}  // namespace

int exit_status(const std::function<cli::ExitCode()>& work) {
  try {
    return static_cast<int>(work());
  } catch (const io::SpecError& error) {
    say(error.what());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string file = error.path1().empty() ? "the current folder" : error.path1().string();
    say(file + ": cannot be reached: " + error.code().message());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::system_error& error) {
    say(std::string("the system refuses what is needed: ") + error.what());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::bad_alloc&) {
    std::fputs(
        "memory: what is asked for takes more than the system gives; a shorter input, fewer "
        "--threads or --jobs, or a higher limit (ulimit -v) may do\n",
        stderr);
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return 70;
  }
}

}  // namespace torquewright::command_line
