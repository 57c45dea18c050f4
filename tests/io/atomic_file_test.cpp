// SPDX-License-Identifier: Apache-2.0
#include "io/files/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/fs.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iterator>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

std::ptrdiff_t entries_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// What writing there is refused with; empty if it is not.
std::string refusal_to_write(const fs::path& file, std::string_view content = "new") {
  try {
    write_whole_file(file, content);
    return "";
  } catch (const SpecError& error) {
    EXPECT_EQ(error.faults().size(), 1u);
    return error.faults().front().message;
  }
}

/// Lets the process write files of no more than so many bytes, for as long as it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ignore_file_size_signal();
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(WriteWholeFile, WritesAndReplaces) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "result.json";
  write_whole_file(file, std::string(100000, 'a'));
  EXPECT_EQ(read_file_bytes(file), std::string(100000, 'a'));
  write_whole_file(file, "short");
  EXPECT_EQ(read_file_bytes(file), "short");
  write_whole_file(file, "");
  EXPECT_EQ(read_file_bytes(file), "");
  EXPECT_EQ(entries_in(folder.path()), 1);
}

TEST(WriteWholeFile, GivesTheRightsOfAnyNewFile) {
  const ScratchFolder folder;
  const mode_t before = ::umask(022);
  write_whole_file(folder.path() / "a", "x");
  ::umask(before);
  EXPECT_EQ(static_cast<int>(fs::status(folder.path() / "a").permissions()), 0644);
}

TEST(WriteWholeFile, RefusesWithOneLine) {
  const ScratchFolder folder;
  folder.write("file", "x");
  EXPECT_EQ(refusal_to_write(folder.path()), "cannot be written: it is a folder");
  EXPECT_EQ(refusal_to_write(folder.path() / ""), "cannot be written: a file's name is missing");
  EXPECT_EQ(refusal_to_write(folder.path() / "none" / "a"),
            "cannot be written: its folder does not exist");
  EXPECT_EQ(refusal_to_write(folder.path() / "file" / "a"),
            "cannot be written: its folder is a file");
  EXPECT_EQ(refusal_to_write("/proc/a"),
            "cannot be written: its folder does not exist");  // read-only to all
}

/// Root may write anywhere; so nobody does it, for as long as this lives.
class WithoutPrivileges {
 public:
  WithoutPrivileges() : is_lowered_(::geteuid() == 0 && ::seteuid(kNobody) == 0) {}
  ~WithoutPrivileges() {
    if (is_lowered_ && ::seteuid(0) != 0) ADD_FAILURE() << "still nobody";
  }

 private:
  static constexpr uid_t kNobody = 65534;
  bool is_lowered_;
};

TEST(WriteWholeFile, RefusesAReadOnlyFolder) {
  const ScratchFolder folder;
  fs::permissions(folder.path(), static_cast<fs::perms>(0555));
  {
    const WithoutPrivileges nobody;
    EXPECT_EQ(refusal_to_write(folder.path() / "a"), "cannot be written: Permission denied");
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(entries_in(folder.path()), 0);
}

// In a sticky folder anyone may make files, but replace only his own: what fails is the exchange
// itself, when the first file stands already.
TEST(WriteWholeFiles, AreTakenBackWhereOneCannotBeReplaced) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs a file of another user's; only root can make one";
  const ScratchFolder folder;
  const fs::path fresh = folder.path() / "a", own = folder.write("b", "old"),
                 foreign = folder.write("c", "old");
  ASSERT_EQ(::chown(own.c_str(), 65534, 65534), 0);
  fs::permissions(folder.path(), static_cast<fs::perms>(01777));
  {
    const WithoutPrivileges nobody;
    EXPECT_THROW(write_whole_files({{fresh, "new"}, {own, "new"}, {foreign, "new"}}), SpecError);
  }
  EXPECT_FALSE(fs::exists(fresh));
  EXPECT_EQ(read_file_bytes(own), "old");
  EXPECT_EQ(read_file_bytes(foreign), "old");
  EXPECT_EQ(entries_in(folder.path()), 2);
}

/// `chattr +i` or `+a` for as long as it lives.
class Marked {
 public:
  Marked(const fs::path& file, int mark) : descriptor_(::open(file.c_str(), O_RDONLY)) {
    is_ = ::ioctl(descriptor_, FS_IOC_GETFLAGS, &before_) == 0 && set(before_ | mark);
  }
  ~Marked() {
    if (is_ && !set(before_)) ADD_FAILURE() << "still marked";
    ::close(descriptor_);
  }
  bool is() const { return is_; }

 private:
  bool set(int flags) const { return ::ioctl(descriptor_, FS_IOC_SETFLAGS, &flags) == 0; }

  int descriptor_;
  int before_ = 0;
  bool is_ = false;
};

TEST(WriteWholeFiles, AreNoneWhereOneIsImmutable) {
  const ScratchFolder folder;
  const fs::path fresh = folder.path() / "a", fixed = folder.write("b", "old");
  const Marked immutable(fixed, FS_IMMUTABLE_FL);
  if (!immutable.is()) GTEST_SKIP() << "needs root, and a file system of immutable files";
  EXPECT_THROW(check_outputs({fresh, fixed}, {}), SpecError);  // before the work
  EXPECT_THROW(write_whole_files({{fresh, "new"}, {fixed, "new"}}), SpecError);
  EXPECT_EQ(read_file_bytes(fixed), "old");
  EXPECT_EQ(entries_in(folder.path()), 1);
}

// What gets a name there keeps it: new content could never take the old file's place, nor go away.
TEST(WriteWholeFile, LeavesNothingInAFolderThatOnlyGrows) {
  const ScratchFolder folder;
  const fs::path old = folder.write("old", "old"), fresh = folder.path() / "fresh";
  const Marked grows(folder.path(), FS_APPEND_FL);
  if (!grows.is()) GTEST_SKIP() << "needs root, and a file system of append-only folders";
  EXPECT_THROW(check_outputs({old}, {}), SpecError);  // before the work
  EXPECT_NE(refusal_to_write(old).find("append-only"), std::string::npos);
  EXPECT_EQ(read_file_bytes(old), "old");
  EXPECT_EQ(refusal_to_write(fresh), "");
  EXPECT_EQ(entries_in(folder.path()), 2);
}

TEST(WriteWholeFile, KeepsTheOldFileIfThereIsNoRoom) {
  const ScratchFolder folder;
  const fs::path file = folder.write("result.json", "old");
  {
    const FileSizeLimit limit(4096);
    EXPECT_EQ(refusal_to_write(file, std::string(4096, 'a')), "");  // just fits
    EXPECT_EQ(refusal_to_write(file, std::string(4097, 'b')), "cannot be written: File too large");
  }
  EXPECT_EQ(read_file_bytes(file), std::string(4096, 'a'));
  EXPECT_EQ(entries_in(folder.path()), 1);  // no temporary file
}

TEST(WriteWholeFile, FollowsALink) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "there");
  const fs::path target = folder.write("there/target", "old");
  fs::create_symlink(target, folder.path() / "link");
  write_whole_file(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file_bytes(target), "new");
}

// A rename would put a plain file in its place. A pipe of the test's own stands for every device:
// with a real one, a mistake in the code under test would break the machine for everybody.
TEST(WriteWholeFile, WritesToAPipeDirectly) {
  const ScratchFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);  // so that no end waits
  ASSERT_GE(reader, 0);
  EXPECT_EQ(refusal_to_write(pipe, "content"), "");
  std::string content(20, '\0');
  const ssize_t count = ::read(reader, content.data(), content.size());
  ::close(reader);
  EXPECT_EQ(content.substr(0, count < 0 ? 0 : static_cast<std::size_t>(count)), "content");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(entries_in(folder.path()), 1);
}

/// Waits until a file of the folder is replaced.
class Watch {
 public:
  explicit Watch(const fs::path& folder) : descriptor_(::inotify_init1(IN_CLOEXEC)) {
    ::inotify_add_watch(descriptor_, folder.c_str(), IN_MOVED_TO);
  }
  ~Watch() { ::close(descriptor_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  bool sees_one() const {
    pollfd ready{descriptor_, POLLIN, 0};
    return ::poll(&ready, 1, 60'000) == 1;
  }

 private:
  int descriptor_;
};

// A signal that comes with the first of a hundred names, each of which takes a rename of its
// own: the others follow before it ends the process.
TEST(WriteWholeFiles, AreAllThereWhateverSignalComesBetween) {
  for (const int signal :
       {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM, SIGPROF,
        SIGPWR, SIGIO, SIGPIPE, SIGSTKFLT, SIGRTMIN, SIGRTMIN + 7, SIGRTMAX}) {
    const ScratchFolder folder;
    std::vector<FileContent> files;
    for (int i = 0; i < 100; ++i) {
      files.push_back({folder.write(std::to_string(i), "old"), "new"});
    }
    const Watch watch(folder.path());
    const pid_t writer = ::fork();
    if (writer == 0) {
      const rlimit no_core{0, 0};
      ::setrlimit(RLIMIT_CORE, &no_core);
      ::signal(signal, SIG_DFL);
      write_whole_files(files);
      ::pause();
    }
    EXPECT_TRUE(watch.sees_one());
    ::kill(writer, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(writer, &status, 0), writer);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_EQ(entries_in(folder.path()), 100) << signal;
    for (const FileContent& each : files) ASSERT_EQ(read_file_bytes(each.file), "new") << signal;
  }
}

}  // namespace
}  // namespace torquewright::io
