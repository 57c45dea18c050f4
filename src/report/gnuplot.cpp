// SPDX-License-Identifier: Apache-2.0
#include "src/report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/refusal.hpp"
#include "io/spec_error.hpp"

extern char** environ;  // NOLINT: the name is POSIX's.

namespace torquewright::report {
namespace {

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

/// Exit code of a program whose libraries find no room.
constexpr int kNotLoaded = 127;

std::string ending_of(int status, const std::string& words) {
  return WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status)) : words;
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
  const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return child;
  if (error == ENOENT) {
    throw io::SpecError({{option, "",
                          "gnuplot, which draws the picture, is not installed "
                          "(Debian: gnuplot-nox)"}});
  }
  io::refuse(option, fmt::format("gnuplot, which draws the picture, cannot be started: {}",
                                 std::generic_category().message(error)));
}

}  // namespace

PlotFormat plot_format(const std::filesystem::path& file) {
  if (file.extension() == ".svg" || file == "-") return PlotFormat::kSvg;
  if (file.extension() == ".png") return PlotFormat::kPng;
  throw io::SpecError(
      {{"--plot", "", fmt::format("\"{}\" must end with .svg or .png", file.string())}});
}

std::string gnuplot_quoted(std::string_view text) {
  // Within single quotes gnuplot expands nothing; a quote is doubled.
  std::string quoted = "'";
  for (const char character : text) {
    if (static_cast<unsigned char>(character) < 0x20) continue;
    quoted += character;
    if (character == '\'') quoted += character;
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
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  std::string picture = drawing.read();
  if (!WIFEXITED(status) || WEXITSTATUS(status) == kNotLoaded) {
    io::refuse(option, "gnuplot, which draws the picture, was stopped by the system: " +
                           ending_of(status, words.read()));
  }
  if (WEXITSTATUS(status) != 0 || picture.empty()) {
    throw std::runtime_error("gnuplot failed: " + words.read());
  }
  return picture;
}

void require_gnuplot(const std::string& option) {
  picture_by_gnuplot(gnuplot_terminal(PlotFormat::kSvg, 100, 100) + "plot x\n", option);
}

void draw_with_gnuplot(const std::string& script, const std::filesystem::path& file) {
  io::write_whole_file(file, picture_by_gnuplot(script));
}

}  // namespace torquewright::report
