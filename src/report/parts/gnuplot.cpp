// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/atomic_file.hpp"
#include "src/report/parts/dark_colours.hpp"
#include "src/report/parts/plot_words.hpp"

extern char** environ;  // NOLINT: the name is POSIX's.

namespace torquewright::report {
namespace {

constexpr std::chrono::seconds kLongest(60);  ///< That a drawing may take.

/// Bytes in memory that a child can take for a file.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : descriptor_(::memfd_create(name, MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return descriptor_; }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw std::system_error(errno, std::generic_category(), "write");
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }

  std::string read() const {
    ::lseek(descriptor_, 0, SEEK_SET);
    std::string text;
    std::array<char, 65536> chunk;
    while (true) {
      const ssize_t count = ::read(descriptor_, chunk.data(), chunk.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return text;
      text.append(chunk.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int descriptor_;
};

/// Without the terminal that somebody draws to on a screen: it may not be installed.
std::vector<char*> variables_without_terminal() {
  std::vector<char*> variables;
  for (char** each = environ; *each != nullptr; ++each) {
    if (!std::string_view(*each).starts_with("GNUTERM=")) variables.push_back(*each);
  }
  variables.push_back(nullptr);
  return variables;
}

/// A process group of its own, since Ctrl-C in a terminal is for us alone, and a file that grows
/// too large ends it: it does not look whether all was written.
class SpawnAttributes {
 public:
  SpawnAttributes() {
    ::posix_spawnattr_init(&attributes_);
    sigset_t usual;
    ::sigemptyset(&usual);
    for (const int signal : {SIGXFSZ, SIGINT, SIGPIPE}) ::sigaddset(&usual, signal);
    ::posix_spawnattr_setsigdefault(&attributes_, &usual);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

/// No picture takes as much. What PATH calls gnuplot may be anything, and outlive us.
void limit(pid_t child) {
  constexpr rlim_t kMostDrawn_bytes = 256 << 20;
  rlimit drawn{};
  if (::prlimit(child, RLIMIT_FSIZE, nullptr, &drawn) != 0) return;
  drawn.rlim_cur = std::min(drawn.rlim_cur, kMostDrawn_bytes);
  ::prlimit(child, RLIMIT_FSIZE, &drawn, nullptr);
  rlimit time{};
  time.rlim_cur = time.rlim_max = static_cast<rlim_t>(kLongest.count());
  ::prlimit(child, RLIMIT_CPU, &time, nullptr);
}

pid_t start_gnuplot(const MemoryFile& script, const MemoryFile& drawing, const MemoryFile& words,
                    const std::string& option) {
  std::string name = "gnuplot";
  std::string no_settings = "-d";  // nobody's own start-up file
  char* arguments[] = {name.data(), no_settings.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, script.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, drawing.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, words.descriptor(), STDERR_FILENO);
  pid_t child = -1;
  const SpawnAttributes attributes;
  const int error = posix_spawnp(&child, arguments[0], &actions, attributes.get(), arguments,
                                 variables_without_terminal().data());
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) {
    limit(child);
    return child;
  }
  if (error == ENOENT) {
    throw io::SpecError({{option, "",
                          "gnuplot, which draws the picture, is not installed "
                          "(Debian: gnuplot-nox)"}});
  }
  io::refuse(option, fmt::format("gnuplot, which draws the picture, cannot be started: {}",
                                 std::generic_category().message(error)));
}

/// Waits for its end; how that went wrong, or nothing.
std::string ending_of(pid_t child) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point latest = Clock::now() + kLongest;
  std::chrono::milliseconds pause(1);
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
    if (Clock::now() > latest) {
      ::kill(-child, SIGKILL);
      ::waitpid(child, &status, 0);
      return fmt::format("had not ended after {} s", kLongest.count());
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(20));
  }
  if (ended < 0) return "ended unseen";
  if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("ended with {}", WEXITSTATUS(status));
}

/// An SVG up to its last mark, or a PNG up to its last chunk.
bool is_whole(std::string_view picture) {
  constexpr std::string_view kLastChunk("IEND\xae\x42\x60\x82", 8);
  if (picture.ends_with(kLastChunk)) return true;
  return picture.substr(0, picture.find_last_not_of(" \n") + 1).ends_with("</svg>");
}

}  // namespace

PlotFormat plot_format(const std::filesystem::path& file) {
  if (file.extension() == ".svg" || file == "-") return PlotFormat::kSvg;
  if (file.extension() == ".png") return PlotFormat::kPng;
  throw io::SpecError(
      {{"--plot", "", fmt::format("\"{}\" must end with .svg or .png", file.string())}});
}

std::string gnuplot_quoted(std::string_view text) {
  // Within single quotes gnuplot expands nothing. It has no escape for one that all versions
  // read, and its SVG leaves "]]>" as it is, which no XML may hold.
  std::string quoted = "'";
  for (const char character : text) {
    if (static_cast<unsigned char>(character) < 0x20) continue;
    if (character == '\'') {
      quoted += "\u2019";
    } else if (character == '>' && quoted.ends_with("]]")) {
      quoted += " >";
    } else {
      quoted += character;
    }
  }
  return quoted + "'";
}

std::string gnuplot_terminal(PlotFormat format, int width, int height) {
  const char* name = format == PlotFormat::kSvg ? "svg" : "pngcairo";
  return fmt::format(
      "set terminal {} size {},{} noenhanced font 'DejaVu Sans,11' background '#ffffff'\n"
      "set encoding utf8\n",
      name, width, height);
}

std::string gnuplot_palette() {
  return "set palette defined (0 '#440154', 0.25 '#3b528b', 0.5 '#21918c', 0.75 '#5ec962', 1 "
         "'#fde725')\n";
}

std::string picture_by_gnuplot(const std::string& script, const std::string& option) {
  const MemoryFile input("script");
  const MemoryFile drawing("drawing");
  const MemoryFile words("words");
  input.write(script);
  const pid_t child = start_gnuplot(input, drawing, words, option);
  const std::string ending = ending_of(child);
  std::string picture = drawing.read();
  if (!ending.empty() || !is_whole(picture)) {
    io::refuse(option, fmt::format("gnuplot, which draws the picture, {}: {}",
                                   ending.empty() ? "drew half of it" : ending, words.read()));
  }
  const bool is_png = picture.starts_with("\x89PNG");
  return is_png ? picture : with_dark_colours(with_plot_words(picture, script));
}

void require_gnuplot(const std::string& option) {
  picture_by_gnuplot(gnuplot_terminal(PlotFormat::kSvg, 100, 100) + "plot x\n", option);
}

void draw_with_gnuplot(const std::string& script, const std::filesystem::path& file) {
  io::write_whole_file(file, picture_by_gnuplot(script));
}

}  // namespace torquewright::report
