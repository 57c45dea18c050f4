// SPDX-License-Identifier: Apache-2.0
#include "io/files/staged_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <random>
#include <system_error>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/file_session.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;

/// Readable and writable for all whom the process's umask admits, as for any new file.
constexpr mode_t kNewFileMode = 0666;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void refuse_folder(const fs::path& file, int error) {
  refuse_output(file, error == ENOENT    ? "its folder does not exist"
                      : error == ENOTDIR ? "its folder is a file"
                                         : reason(error));
}

/// Whether the system says so of the path (chattr): STATX_ATTR_APPEND, STATX_ATTR_IMMUTABLE.
bool is_marked(const fs::path& path, std::uint64_t attributes) {
  struct statx status {};
  return ::statx(AT_FDCWD, path.c_str(), 0, STATX_BASIC_STATS, &status) == 0 &&
         (status.stx_attributes & attributes) != 0;
}

/// A name in that folder that nobody else has.
fs::path temporary_in(const fs::path& folder) {
  static std::random_device entropy;
  const auto half = [] { return static_cast<std::uint32_t>(entropy()); };
  return folder / fmt::format(".torquewright-{:08x}{:08x}.tmp", half(), half());
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Where a name can be given and never be taken away again: what stands there stays.
void refuse_append_only_folder(const Target& target) {
  if (!target.exists || !is_marked(folder_of(target.path), STATX_ATTR_APPEND)) return;
  refuse_output(target.file, "its folder is marked as append-only, and nothing in it is replaced");
}

}  // namespace

Target::Target(const fs::path& the_file) : file(the_file), path(the_file) {
  if (!file.has_filename()) refuse_output(file, "a file's name is missing");
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (fs::is_directory(status)) refuse_output(file, "it is a folder");
  is_direct = fs::is_other(status) || named_descriptor(file);
  exists = fs::exists(status);
  if (!is_direct && fs::is_symlink(fs::symlink_status(file, unknown))) {
    if (!exists) refuse_output(file, "it is a link to a file that does not exist");
    path = fs::canonical(file);
  }
  if (is_input(path)) refuse_output(file, "it is an input, which would be lost");
  if (const auto stream = stream_into(path); stream && !is_direct) {
    refuse_output(file, fmt::format("it is what {} leads into, which would be lost", *stream));
  }
}

void require_writable(const Target& target) {
  if (target.is_direct) return require_open(target.file);
  const fs::path folder = folder_of(target.path);
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) refuse_folder(target.file, errno);
  if (!S_ISDIR(status.st_mode)) refuse_folder(target.file, ENOTDIR);
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    refuse_output(target.file, reason(errno));
  }
  // A name that is too long, say.
  if (::lstat(target.path.c_str(), &status) != 0 && errno != ENOENT) {
    refuse_output(target.file, reason(errno));
  }
  if (is_marked(target.path, STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) {
    refuse_output(target.file, "it is marked as immutable");
  }
  refuse_append_only_folder(target);
}

StagedFile::StagedFile(Target target, std::string_view content, Source more)
    : target_(std::move(target)), content_(content), more_(std::move(more)) {}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      content_(other.content_),
      more_(std::move(other.more_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      published_(other.published_) {}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void StagedFile::stage() {
  refuse_append_only_folder(target_);
  open();
  keep_owner_and_mode();
  const auto write = [&](std::string_view piece) {
    const int error = write_all(descriptor_, piece);
    if (error != 0) refuse_output(target_.file, reason(error));
  };
  write(content_);
  if (more_) more_(write);
  // Some file systems report a full disk as late as here.
  if (::fsync(descriptor_) != 0) refuse_output(target_.file, reason(errno));
}

void StagedFile::open() {
  const fs::path folder = folder_of(target_.path);
  descriptor_ = ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, kNewFileMode);
  while (descriptor_ < 0) {
    if (is_marked(folder, STATX_ATTR_APPEND)) {  // a temporary name would stay
      refuse_output(target_.file, "its folder is marked as append-only");
    }
    const fs::path name = temporary_in(folder);
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
    if (descriptor_ >= 0) temporary_ = name;
    if (descriptor_ < 0 && errno != EEXIST) refuse_folder(target_.file, errno);
  }
}

void StagedFile::publish() {
  if (temporary_.empty() && !target_.exists && takes_name(target_.path)) {
    published_ = Published::kNew;
    return;
  }
  if (temporary_.empty()) give_temporary_name();
  // The former file takes the temporary name, so that there is a way back.
  if (target_.exists && ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.path.c_str(),
                                    RENAME_EXCHANGE) == 0) {
    published_ = Published::kExchanged;
    return;
  }
  if (::rename(temporary_.c_str(), target_.path.c_str()) != 0) {
    refuse_output(target_.file, reason(errno));
  }
  temporary_.clear();
  published_ = target_.exists ? Published::kForGood : Published::kNew;
}

void StagedFile::withdraw() {
  if (published_ == Published::kNew) ::unlink(target_.path.c_str());
  if (published_ != Published::kExchanged) return;
  ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.path.c_str(), RENAME_EXCHANGE);
}

bool StagedFile::takes_name(const fs::path& name) const {
  const std::string unnamed = fmt::format("/proc/self/fd/{}", descriptor_);
  return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

void StagedFile::give_temporary_name() {
  do {
    temporary_ = temporary_in(folder_of(target_.path));
    if (takes_name(temporary_)) return;
  } while (errno == EEXIST);
  temporary_.clear();
  refuse_output(target_.file, reason(errno));
}

void StagedFile::keep_owner_and_mode() const {
  struct stat former {};
  if (!target_.exists || ::stat(target_.path.c_str(), &former) != 0) return;
  // Only root gives files away; for others the file becomes theirs, as with any editor.
  if (::fchown(descriptor_, former.st_uid, former.st_gid) != 0) errno = 0;
  ::fchmod(descriptor_, former.st_mode & 07777);
}

}  // namespace torquewright::io
