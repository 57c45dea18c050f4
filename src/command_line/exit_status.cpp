// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/exit_status.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

#include "io/spec_error.hpp"

namespace torquewright::command_line {

int exit_status(const std::function<cli::ExitCode()>& work) {
  try {
    return static_cast<int>(work());
  } catch (const io::SpecError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string file = error.path1().empty() ? "the current folder" : error.path1().string();
    std::fprintf(stderr, "%s: cannot be reached: %s\n", file.c_str(),
                 error.code().message().c_str());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "the system refuses what is needed: %s\n", error.what());
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
