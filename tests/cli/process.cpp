// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/process.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace torquewright::cli_test {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::chrono::seconds kPatience{600};  // so built, the program takes many times as long
#else
constexpr std::chrono::seconds kPatience{120};
#endif
constexpr std::chrono::seconds kSignalPatience{20};
constexpr milliseconds kLookAgain{10};
constexpr uid_t kNobody = 65534;

struct Pipe {
  std::array<int, 2> ends{};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
};

bool limit(int resource, const std::optional<rlim_t>& most) {
  if (!most) return true;
  const rlimit limits{*most, *most};
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &limits) == 0;
}

/// The built program, or what scripts/compare_outputs puts in its place.
std::string program() {
  const char* stand_in = std::getenv("TORQUEWRIGHT_STAND_IN");
  return stand_in == nullptr ? TORQUEWRIGHT_PROGRAM : stand_in;
}

bool become_nobody() {
  return ::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0;
}

/// In the child: never returns.
[[noreturn]] void become_program(std::vector<std::string> arguments,
                                 const Circumstances& circumstances, const Pipe& out,
                                 const Pipe& err) {
  // A shell lets what it starts in the background ignore Ctrl-C: a test run, say.
  ::signal(SIGINT, circumstances.ignores_interrupt ? SIG_IGN : SIG_DFL);
  arguments.insert(arguments.begin(), program());
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::vector<std::string> environment = circumstances.environment;
  for (std::string& variable : environment) ::putenv(variable.data());
  int to = out.ends[1];
  if (!circumstances.stdout_file.empty()) {
    to = ::open(circumstances.stdout_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  }
  const bool is_ready = ::chdir(circumstances.folder.c_str()) == 0 &&
                        ::dup2(to, STDOUT_FILENO) >= 0 && ::dup2(err.ends[1], STDERR_FILENO) >= 0 &&
                        limit(RLIMIT_FSIZE, circumstances.file_size_limit) &&
                        limit(RLIMIT_AS, circumstances.memory_limit) &&
                        limit(RLIMIT_STACK, circumstances.stack_limit) &&
                        (!circumstances.as_nobody || become_nobody());
  if (is_ready && circumstances.closes_stderr) ::close(STDERR_FILENO);
  if (is_ready) ::execv(words.front(), words.data());
  ::_exit(kNotStarted);
}

/// Whether a process has installed a handler for Ctrl-C.
bool listens_for_interrupt(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    const auto caught = std::stoull(line.substr(line.find('\t') + 1), nullptr, 16);
    return (caught >> (SIGINT - 1) & 1U) != 0;
  }
  return false;
}

/// Sends signals when their time has come.
class Interrupter {
 public:
  Interrupter(pid_t process, const Circumstances& circumstances)
      : process_(process), delay_(circumstances.interrupt_after), signal_(circumstances.signal) {}

  void look() {
    if (signal_ && Clock::now() - start_ >= signal_->after) {
      ::kill(process_, signal_->number);
      signal_.reset();
    }
    if (!delay_) return;
    if (!listening_since_ && listens_for_interrupt(process_)) listening_since_ = Clock::now();
    if (!listening_since_ || Clock::now() - *listening_since_ < *delay_) return;
    ::kill(process_, SIGINT);
    delay_.reset();
  }

 private:
  pid_t process_;
  Clock::time_point start_ = Clock::now();
  std::optional<milliseconds> delay_;
  std::optional<Signal> signal_;
  std::optional<Clock::time_point> listening_since_;
};

/// Reads both pipes until the program has closed them. False: it took too long.
bool collect(int out, int err, Interrupter interrupter, Outcome& outcome) {
  const auto deadline = Clock::now() + kPatience;
  std::array<pollfd, 2> open{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  std::array<std::string*, 2> texts{&outcome.out, &outcome.err};
  std::array<char, 1 << 16> chunk;
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (Clock::now() > deadline) return false;
    ::poll(open.data(), open.size(), static_cast<int>(kLookAgain.count()));
    interrupter.look();
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i].fd < 0 || open[i].revents == 0) continue;
      const ssize_t count = ::read(open[i].fd, chunk.data(), chunk.size());
      if (count > 0) texts[i]->append(chunk.data(), static_cast<std::size_t>(count));
      if (count == 0) open[i].fd = -1;
    }
  }
  return true;
}

bool ends_within(pid_t child, std::chrono::seconds patience) {
  const auto deadline = Clock::now() + patience;
  while (::waitpid(child, nullptr, WNOHANG) == 0) {
    if (Clock::now() > deadline) return false;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return true;
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
  const Pipe out, err;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_program(arguments, circumstances, out, err);
  ::close(out.ends[1]);
  ::close(err.ends[1]);
  Outcome outcome;
  outcome.has_ended = collect(out.ends[0], err.ends[0], Interrupter(child, circumstances), outcome);
  if (!outcome.has_ended) ::kill(child, SIGKILL);
  ::close(out.ends[0]);
  ::close(err.ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  return outcome;
}

bool run_and_kill(const std::vector<std::string>& arguments, const Circumstances& circumstances,
                  int signal, std::chrono::microseconds after) {
  const Pipe out, err;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_program(arguments, circumstances, out, err);
  for (const Pipe* pipe : {&out, &err}) ::close(pipe->ends[1]);
  std::this_thread::sleep_for(after);
  ::kill(child, signal);
  const bool has_ended = ends_within(child, kSignalPatience);
  if (!has_ended) ::kill(child, SIGKILL);
  if (!has_ended) ::waitpid(child, nullptr, 0);
  for (const Pipe* pipe : {&out, &err}) ::close(pipe->ends[0]);
  return has_ended;
}

}  // namespace torquewright::cli_test
