// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/fork_client.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace torquewright::fuzz {
namespace {

[[noreturn]] void become_server(const std::filesystem::path& server, int channel) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::fcntl(channel, F_SETFD, 0);
  ::setenv(kForkChannelVariable, std::to_string(channel).c_str(), 1);
  ::execl(server.c_str(), server.c_str(), nullptr);
  ::_exit(kNotStarted);
}

/// As another process opens it.
std::string descriptor_of_this_process(int descriptor) {
  return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor);
}

}  // namespace

ForkClient::ForkClient(const std::filesystem::path& server) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::runtime_error("no channel");
  }
  server_ = ::fork();
  if (server_ == 0) become_server(server, ends[1]);
  ::close(ends[1]);
  channel_ = ends[0];
  if (server_ < 0) throw std::runtime_error("no process");
}

ForkClient::~ForkClient() {
  ::close(channel_);
  ::waitpid(server_, nullptr, 0);
}

pid_t ForkClient::start(const Words& arguments, const Circumstances& circumstances,
                        int standard_output, int standard_error) {
  Words request{circumstances.folder.string(), circumstances.temporary.string(),
                descriptor_of_this_process(standard_output),
                descriptor_of_this_process(standard_error), circumstances.program.string()};
  request.insert(request.end(), arguments.begin(), arguments.end());
  pid_t run = -1;
  if (!send(channel_, request) || !receive_value(channel_, run)) {
    throw std::runtime_error("the program that runs are copies of does not answer");
  }
  if (run < 0) throw std::runtime_error("no process");
  return run;
}

RunEnd ForkClient::wait() {
  RunEnd end;
  if (!receive_value(channel_, end)) throw std::runtime_error("nobody says how the run ended");
  return end;
}

}  // namespace torquewright::fuzz
