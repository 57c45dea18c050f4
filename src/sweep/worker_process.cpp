// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/worker_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/own_arguments.hpp"
#include "src/sweep/worker_channel.hpp"

extern char** environ;  // NOLINT: the name is POSIX's.

namespace torquewright::sweep {
namespace {

/// A pipe's ends, closed by the object unless they are taken.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::system_error(errno, std::generic_category(), "pipe");
    }
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int take(std::size_t end) { return std::exchange(ends[end], -1); }
};

/// This process's, and whose worker it is.
std::vector<std::string> environment() {
  std::vector<std::string> words;
  for (char** word = environ; *word != nullptr; ++word) words.emplace_back(*word);
  words.push_back(fmt::format("{}={}", kWorkerVariable, ::getpid()));
  return words;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Its stdin is empty and its stdout goes nowhere. It is a process group of its own: Ctrl-C in a
/// terminal is for who started it alone.
pid_t spawned(const Pipe& down, const Pipe& up) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, down.ends[0], kWorkerReads);
  posix_spawn_file_actions_adddup2(&actions, up.ends[1], kWorkerWrites);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<std::string> arguments = io::own_arguments();
  std::vector<std::string> variables = environment();
  pid_t child = -1;
  const int error = posix_spawn(&child, "/proc/self/exe", &actions, &attributes,
                                pointers_to(arguments).data(), pointers_to(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    io::refuse("--jobs", fmt::format("the system starts no further process: {}; ask for fewer, or "
                                     "raise its limit (ulimit -u)",
                                     std::generic_category().message(error)));
  }
  return child;
}

}  // namespace

WorkerProcess::WorkerProcess(std::string fingerprint) : fingerprint_(std::move(fingerprint)) {
  Pipe down, up;
  process_ = spawned(down, up);
  to_ = down.take(1);
  from_ = up.take(0);
  ::fcntl(from_, F_SETFL, O_NONBLOCK);
}

WorkerProcess::~WorkerProcess() {
  if (!has_ended_) reap(true);
  ::close(to_);
  ::close(from_);
}

void WorkerProcess::reap(bool kill) {
  if (kill) ::kill(process_, SIGKILL);
  while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) continue;
  has_ended_ = true;
}

void WorkerProcess::hand_out(std::size_t point) {
  point_ = point;
  io::write_all(to_, fmt::format("{}\n", point));  // one that has ended is seen by listen()
}

std::optional<PointAnswer> WorkerProcess::listen() {
  std::array<char, 1 << 14> chunk;
  const ssize_t count = ::read(from_, chunk.data(), chunk.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return std::nullopt;
  if (count <= 0) {
    reap(false);
    return std::nullopt;
  }
  bytes_.append(chunk.data(), static_cast<std::size_t>(count));
  std::optional<PointAnswer> answer;
  for (const std::string& text : take_lines(bytes_)) {
    WorkerLine line = read_worker_line(text);
    switch (line.kind) {
      case WorkerLine::Kind::kReady:
        has_begun_ = true;
        if (line.text != fingerprint_) {
          io::refuse("--sweep", "the inputs have changed since it began, or can be read only once");
        }
        break;
      case WorkerLine::Kind::kDone:
        answer = PointAnswer{line.point, {false, std::move(line.text), ""}};
        break;
      case WorkerLine::Kind::kLost:
        answer = PointAnswer{line.point, {true, "", std::move(line.text)}};
        break;
      case WorkerLine::Kind::kUnknown:
        break;
    }
  }
  if (answer) point_.reset();
  return answer;
}

std::optional<int> WorkerProcess::exit_code() const {
  if (!has_ended_ || !WIFEXITED(status_)) return std::nullopt;
  return WEXITSTATUS(status_);
}

std::string WorkerProcess::how_it_ended() const {
  if (const auto code = exit_code()) {
    return fmt::format("its process ended with exit code {}", *code);
  }
  return fmt::format("its process was ended by signal {} ({})", WTERMSIG(status_),
                     ::strsignal(WTERMSIG(status_)));
}

}  // namespace torquewright::sweep
