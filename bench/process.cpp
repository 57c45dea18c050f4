// SPDX-License-Identifier: Apache-2.0
#include "bench/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

extern char** environ;  // NOLINT: the name is POSIX's.

namespace torquewright::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The child writes to `writer`; its group has its own number as leader's.
pid_t start(const std::vector<std::string>& arguments, int writer) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, writer, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t child = -1;
  if (posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ) != 0) child = -1;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return child;
}

// True at the end of the child's output, false when time is up.
bool read_until(int reader, Clock::time_point begin, double timeout_s, std::string& output) {
  std::array<char, 4096> buffer;
  while (true) {
    const double left_s = timeout_s - seconds_since(begin);
    pollfd waiting{reader, POLLIN, 0};
    if (left_s <= 0) return false;
    if (poll(&waiting, 1, static_cast<int>(left_s * 1000) + 1) <= 0) continue;
    const ssize_t count = read(reader, buffer.data(), buffer.size());
    if (count <= 0) return true;
    output.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ProcessOutcome run_process(const std::vector<std::string>& arguments, double timeout_s) {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  ProcessOutcome outcome;
  const Clock::time_point begin = Clock::now();
  const pid_t child = start(arguments, ends[1]);
  close(ends[1]);
  outcome.started = child > 0;
  if (outcome.started) {
    outcome.timed_out = !read_until(ends[0], begin, timeout_s, outcome.output);
    if (outcome.timed_out) kill(-child, SIGKILL);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    outcome.seconds = seconds_since(begin);
    outcome.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    outcome.peak_MB = static_cast<double>(usage.ru_maxrss) / 1024.0;  // Of Linux: in kB.
  }
  close(ends[0]);
  return outcome;
}

}  // namespace torquewright::bench
