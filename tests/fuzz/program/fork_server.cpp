// SPDX-License-Identifier: Apache-2.0
// The program with its libraries loaded, of which each run is a copy: most of what a short run
// takes is to load them.
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "tests/fuzz/program/fork_channel.hpp"

int program_main(int argc, char** argv);  // src/main.cpp

namespace torquewright::fuzz {
namespace {

/// What a run reads and writes. Opened before it begins, for who asked closes its own ends then.
struct Streams {
  int in = -1, out = -1, err = -1;

  explicit Streams(const Words& request)
      : in(::open("/dev/null", O_RDONLY | O_CLOEXEC)),
        out(::open(request[kStandardOutput].c_str(), O_WRONLY | O_CLOEXEC)),
        err(::open(request[kStandardError].c_str(), O_WRONLY | O_CLOEXEC)) {}
  ~Streams() {
    for (const int opened : {in, out, err}) ::close(opened);
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
};

/// In the copy.
[[noreturn]] void become_run(Words request, const Streams& streams, int channel) {
  ::close(channel);
  ::unsetenv(kForkChannelVariable);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGINT, SIG_DFL);
  const bool is_ready = ::chdir(request[kFolder].c_str()) == 0 &&
                        ::setenv("TMPDIR", request[kTemporary].c_str(), 1) == 0 &&
                        ::dup2(streams.in, STDIN_FILENO) >= 0 &&
                        ::dup2(streams.out, STDOUT_FILENO) >= 0 &&
                        ::dup2(streams.err, STDERR_FILENO) >= 0;
  if (!is_ready) ::_exit(kNotStarted);
  for (const int opened : {streams.in, streams.out, streams.err}) ::close(opened);
  std::vector<char*> words;
  for (std::size_t i = kProgram; i < request.size(); ++i) words.push_back(request[i].data());
  const int count = static_cast<int>(words.size());
  words.push_back(nullptr);
  std::exit(program_main(count, words.data()));
}

/// Its number.
pid_t start_copy(const Words& request, int channel) {
  const Streams streams(request);
  const pid_t copy = ::fork();
  if (copy == 0) become_run(request, streams, channel);
  return copy;
}

/// Answers with the copy's number, and with how it ended.
int serve(int channel) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (Words request; receive(channel, request);) {
    const pid_t copy = start_copy(request, channel);
    RunEnd end;
    if (!send_value(channel, copy)) return EXIT_FAILURE;
    while (::wait4(copy, &end.status, 0, &end.used) < 0 && errno == EINTR) {
    }
    if (!send_value(channel, end)) return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace torquewright::fuzz

int main(int argc, char** argv) {
  const char* channel = std::getenv(torquewright::fuzz::kForkChannelVariable);
  if (channel == nullptr) return program_main(argc, argv);
  return torquewright::fuzz::serve(static_cast<int>(std::strtol(channel, nullptr, 10)));
}
