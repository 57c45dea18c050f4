// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/runner.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>

#include "tests/fuzz/program/fork_client.hpp"

namespace torquewright::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kWholeOutput = 1 << 16;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

struct Pipe {
  std::array<int, 2> ends = made();
  Descriptor read_end{ends[0]}, write_end{ends[1]};

  static std::array<int, 2> made() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
  }
};

/// In the child: never returns.
[[noreturn]] void become_program(const Words& arguments, const Circumstances& circumstances,
                                 const Pipe& out, const Pipe& err) {
  Words all{circumstances.program.string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  for (std::string& word : all) words.push_back(word.data());
  words.push_back(nullptr);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGINT, SIG_DFL);  // a shell lets what it starts in the background ignore it
  const bool is_ready = ::chdir(circumstances.folder.c_str()) == 0 &&
                        ::setenv("TMPDIR", circumstances.temporary.c_str(), 1) == 0 &&
                        ::dup2(nothing, STDIN_FILENO) >= 0 &&
                        ::dup2(out.write_end.number(), STDOUT_FILENO) >= 0 &&
                        ::dup2(err.write_end.number(), STDERR_FILENO) >= 0;
  if (is_ready) ::execv(words.front(), words.data());
  ::_exit(kNotStarted);
}

/// Reads all it can now. False: the other side has closed.
bool read_some(int descriptor, std::string* text) {
  static std::array<char, kWholeOutput> chunk;
  const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
  if (count <= 0) return count < 0 && (errno == EAGAIN || errno == EINTR);
  const std::size_t room = text == nullptr ? 0 : kMostOutput - std::min(kMostOutput, text->size());
  if (text != nullptr) text->append(chunk.data(), std::min(room, static_cast<std::size_t>(count)));
  return true;
}

/// Sends the signal when its moment has come.
class Killer {
 public:
  Killer(pid_t child, const std::optional<Kill>& kill) : child_(child), kill_(kill) {}

  void look() {
    if (!kill_ || Clock::now() - start_ < kill_->after) return;
    ::kill(child_, kill_->signal);
    kill_.reset();
  }
  bool waits() const { return kill_.has_value(); }
  std::chrono::microseconds left() const {
    return std::chrono::duration_cast<std::chrono::microseconds>(start_ + kill_->after -
                                                                 Clock::now());
  }

 private:
  pid_t child_;
  std::optional<Kill> kill_;
  Clock::time_point start_ = Clock::now();
};

timespec until_next_look(const Killer& killer, Clock::time_point deadline) {
  const auto rest = std::chrono::duration_cast<std::chrono::microseconds>(deadline - Clock::now());
  auto wait = std::min<std::chrono::microseconds>(rest, milliseconds(500));
  if (killer.waits()) wait = std::min(wait, killer.left());
  const auto count = std::max<long>(wait.count(), 0);
  return {count / 1'000'000, (count % 1'000'000) * 1000};
}

/// Reads until stdout and stderr are closed. False: it took too long.
bool collect(std::vector<pollfd>& open, Outcome& outcome, Killer& killer,
             Clock::time_point deadline) {
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (Clock::now() > deadline) return false;
    const timespec wait = until_next_look(killer, deadline);
    ::ppoll(open.data(), open.size(), &wait, nullptr);
    killer.look();
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i].fd < 0 || open[i].revents == 0) continue;
      std::string* text = i == 0 ? &outcome.out : i == 1 ? &outcome.err : nullptr;
      if (!read_some(open[i].fd, text) && i < 2) open[i].fd = -1;
    }
  }
  return true;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

pid_t started(const Words& arguments, const Circumstances& circumstances, const Pipe& out,
              const Pipe& err) {
  const int to_out = out.write_end.number(), to_err = err.write_end.number();
  if (circumstances.copies != nullptr) {
    return circumstances.copies->start(arguments, circumstances, to_out, to_err);
  }
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_program(arguments, circumstances, out, err);
  return child;
}

RunEnd end_of(pid_t child, const Circumstances& circumstances) {
  if (circumstances.copies != nullptr) return circumstances.copies->wait();
  RunEnd end;
  while (::wait4(child, &end.status, 0, &end.used) < 0 && errno == EINTR) {
  }
  return end;
}

void take(const RunEnd& end, Outcome& outcome) {
  if (WIFEXITED(end.status)) outcome.exit_code = WEXITSTATUS(end.status);
  if (WIFSIGNALED(end.status)) outcome.signal = WTERMSIG(end.status);
  outcome.processor_s = seconds(end.used.ru_utime) + seconds(end.used.ru_stime);
  outcome.resident_MB = static_cast<double>(end.used.ru_maxrss) / 1024.0;
}

}  // namespace

Outcome run(const Words& arguments, const Circumstances& circumstances,
            const std::optional<Kill>& kill) {
  Pipe out, err;
  std::vector<int> readers;  // opened for both, so that a pipe is never without somebody
  for (const auto& pipe : circumstances.pipes) {
    const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (reader >= 0) readers.push_back(reader);
  }
  const auto start = Clock::now();
  const pid_t child = started(arguments, circumstances, out, err);
  Killer killer(child, kill);
  out.write_end.close();
  err.write_end.close();
  std::vector<pollfd> open{{out.read_end.number(), POLLIN, 0}, {err.read_end.number(), POLLIN, 0}};
  for (const int reader : readers) open.push_back({reader, POLLIN, 0});
  Outcome outcome;
  outcome.has_ended = collect(open, outcome, killer, start + circumstances.patience);
  if (!outcome.has_ended) ::kill(child, SIGKILL);
  take(end_of(child, circumstances), outcome);
  outcome.clock_s = std::chrono::duration<double>(Clock::now() - start).count();
  for (const int reader : readers) ::close(reader);
  if (outcome.exit_code == kNotStarted) throw std::runtime_error("the program does not start");
  return outcome;
}

}  // namespace torquewright::fuzz
