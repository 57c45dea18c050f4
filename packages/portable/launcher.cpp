// SPDX-License-Identifier: Apache-2.0
// bin/torquewright of the portable archive. It is linked statically and starts the program of
// ../lib/torquewright by the loader that lies there, with the libraries that lie there: nothing of
// the system's is needed, neither a C library nor a shell.
#include <sys/auxv.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr int kCannotStart = 2;

/// Where this file lies; without /proc, what the system says that it was started as.
std::string own_path() {
  std::array<char, PATH_MAX> path{};
  const ssize_t length = ::readlink("/proc/self/exe", path.data(), path.size() - 1);
  if (length > 0) return {path.data(), static_cast<std::size_t>(length)};
  const auto* started = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  if (started == nullptr || ::realpath(started, path.data()) == nullptr) return "";
  return path.data();
}

std::string_view folder_of(std::string_view path) { return path.substr(0, path.rfind('/')); }

int complain(const std::string& what) {
  const std::string line = "torquewright: " + what + "\n";
  const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
  return written < 0 ? 1 : kCannotStart;
}

int start(const std::string& libraries, char** arguments) {
  std::string loader = libraries + "/ld-linux-x86-64.so.2";
  std::string program = libraries + "/torquewright";
  std::string argv0 = "--argv0", no_cache = "--inhibit-cache", path = "--library-path";
  std::string folder = libraries;
  std::vector<char*> words{loader.data(), argv0.data(),  arguments[0],  no_cache.data(),
                           path.data(),   folder.data(), program.data()};
  for (char** each = arguments + 1; *each != nullptr; ++each) words.push_back(*each);
  words.push_back(nullptr);
  ::execv(loader.c_str(), words.data());
  return complain(loader + ": " + std::strerror(errno) +
                  "; unpack the whole archive, and leave bin/ and lib/ beside each other");
}

}  // namespace

int main(int count, char** arguments) {
  const std::string path = own_path();
  if (count < 1 || path.empty()) {
    return complain("cannot find out where it lies; start it by its whole path, or mount /proc");
  }
  const std::string libraries = std::string(folder_of(folder_of(path))) + "/lib/torquewright";
  // The loader would cut the folder's name there.
  if (const std::size_t at = libraries.find_first_of(":;$"); at != std::string::npos) {
    return complain(libraries + ": holds '" + libraries[at] +
                    "', which the system's loader does not take; unpack the archive elsewhere");
  }
  return start(libraries, arguments);
}
