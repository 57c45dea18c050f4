// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/watch.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <thread>
#include <tuple>

#include "io/faults/spec_error.hpp"
#include "io/files/file_session.hpp"
#include "src/interrupt.hpp"
#include "src/loudness.hpp"

namespace torquewright::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};

/// What changes when a file is written or replaced; all zero where there is none.
using Stamp = std::tuple<ino_t, off_t, time_t, long>;
using Stamps = std::map<std::filesystem::path, Stamp>;

Stamp stamp_of(const struct stat& status) {
  return {status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

Stamp stamp_now(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? stamp_of(status) : Stamp();
}

Stamps now(const Stamps& watched) {
  Stamps stamps;
  for (const auto& [file, before] : watched) stamps[file] = stamp_now(file);
  return stamps;
}

/// As they were when the work read them; those that it did not come to this time as they are now.
Stamps stamps_of_work(const Stamps& watched) {
  Stamps stamps = now(watched);
  for (const io::ReadFile& read : io::files_read()) stamps[read.file] = stamp_of(read.status);
  return stamps;
}

/// Until a file differs and has not changed between two looks: who writes it has ended. False:
/// Ctrl-C.
bool waits_for_change(const Stamps& known) {
  for (Stamps before = known; !is_interrupted();) {
    std::this_thread::sleep_for(kBetweenLooks);
    Stamps here = now(known);
    if (here != known && here == before) return true;
    before = std::move(here);
  }
  return false;
}

void say_what_is_watched(const Stamps& files) {
  if (loudness().is_quiet) return;
  std::fprintf(stderr, "watching %zu file%s; Ctrl-C ends it\n", files.size(),
               files.size() == 1 ? "" : "s");
}

}  // namespace

ExitCode watch(const std::function<ExitCode()>& work) {
  catch_interrupt();
  ExitCode code = work();
  Stamps watched = stamps_of_work({});
  say_what_is_watched(watched);
  while (waits_for_change(watched)) {
    io::forget_files_read();
    try {
      code = work();
    } catch (const io::SpecError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      code = ExitCode::kBadInput;
    }
    watched = stamps_of_work(watched);
  }
  if (isatty(STDERR_FILENO) == 1) std::fputs("\n", stderr);  // behind the ^C that is shown there
  return code;
}

}  // namespace torquewright::cli
