// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>
#include <utility>

#include "io/spec_error.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;

/// Readable and writable for all whom the process's umask admits, as for any new file.
constexpr mode_t kNewFileMode = 0666;

[[noreturn]] void refuse_to_write(const fs::path& file, const std::string& why) {
  throw SpecError({{file.string(), "", "cannot be written: " + why}});
}

std::string reason(int error) { return std::generic_category().message(error); }

/// 0, or the errno of what failed. Closes the descriptor in any case.
int write_and_close(int descriptor, std::string_view content, bool is_disk_file) {
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count >= 0) {
      content.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && is_disk_file && ::fsync(descriptor) != 0) error = errno;
  // Network file systems report a full disk as late as here.
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// In the same folder, since only there can the rename be atomic; a name that nobody else has.
fs::path temporary_beside(const fs::path& file) {
  static std::atomic<unsigned> count{0};
  return file.parent_path() / fmt::format(".torquewright-{}-{}.tmp", ::getpid(), ++count);
}

/// Content under way to its file: written whole under a temporary name, it takes the file's name
/// with publish() and is gone without.
class StagedFile {
 public:
  StagedFile(const fs::path& file, std::string_view content) : file_(file), content_(content) {
    if (!file.has_filename()) refuse_to_write(file, "a file's name is missing");
    std::error_code unknown;
    const fs::file_status status = fs::status(file, unknown);
    if (fs::is_directory(status)) refuse_to_write(file, "it is a folder");
    is_direct_ = fs::is_other(status);
    if (is_direct_) return;
    const bool is_link = fs::is_symlink(fs::symlink_status(file, unknown)) && fs::exists(status);
    target_ = is_link ? fs::canonical(file) : file;
    write_temporary();
  }
  StagedFile(StagedFile&& other) noexcept
      : file_(std::move(other.file_)),
        target_(std::move(other.target_)),
        temporary_(std::exchange(other.temporary_, {})),
        content_(other.content_),
        is_direct_(other.is_direct_) {}
  ~StagedFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  void publish() {
    if (is_direct_) return write_directly();
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) refuse_to_write(file_, reason(errno));
    temporary_.clear();
  }

 private:
  void write_temporary() {
    const fs::path temporary = temporary_beside(target_);
    const int descriptor =
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
    if (descriptor < 0) {
      refuse_to_write(file_, errno == ENOENT    ? "its folder does not exist"
                             : errno == ENOTDIR ? "its folder is a file"
                                                : reason(errno));
    }
    const int error = write_and_close(descriptor, content_, true);
    if (error != 0) ::unlink(temporary.c_str());
    if (error != 0) refuse_to_write(file_, reason(error));
    temporary_ = temporary;
  }

  /// Into a pipe or a device.
  void write_directly() const {
    const int descriptor = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) refuse_to_write(file_, reason(errno));
    const int error = write_and_close(descriptor, content_, false);
    if (error != 0) refuse_to_write(file_, reason(error));
  }

  fs::path file_;       ///< As the user named it.
  fs::path target_;     ///< With links followed.
  fs::path temporary_;  ///< Empty: there is none.
  std::string_view content_;
  bool is_direct_ = false;
};

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code unknown;
  const fs::file_status status = fs::status(a, unknown);
  if (fs::is_other(status)) return false;  // a device takes whatever comes
  if (fs::exists(status)) return fs::equivalent(a, b, unknown);
  return fs::weakly_canonical(fs::absolute(a), unknown) ==
         fs::weakly_canonical(fs::absolute(b), unknown);
}

bool contains(const std::vector<fs::path>& files, const fs::path& file) {
  return std::any_of(files.begin(), files.end(),
                     [&](const fs::path& each) { return is_same_file(each, file); });
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view content) {
  StagedFile(file, content).publish();
}

void write_whole_files(const std::vector<FileContent>& files) {
  std::vector<StagedFile> staged;
  for (const auto& [file, content] : files) staged.emplace_back(file, content);
  for (StagedFile& file : staged) file.publish();
}

void check_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::vector<Fault> faults;
  std::vector<fs::path> seen;
  for (const fs::path& output : outputs) {
    try {
      const StagedFile never_published(output, "");
      if (contains(inputs, output)) refuse_to_write(output, "it is an input, which would be lost");
      if (contains(seen, output)) refuse_to_write(output, "it is named for two outputs");
    } catch (const SpecError& error) {
      faults.push_back(error.faults().front());
    }
    seen.push_back(output);
  }
  if (!faults.empty()) throw SpecError(std::move(faults));
}

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace torquewright::io
