// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "src/sweep/answer.hpp"

namespace torquewright::sweep {

/// A child process of this program that does points, one at a time. Ends with the object.
class WorkerProcess {
 public:
  explicit WorkerProcess(std::string fingerprint);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Requires that it has none.
  void hand_out(std::size_t point);
  std::optional<std::size_t> point() const { return point_; }

  /// Readable where listen() has something to do.
  int descriptor() const { return from_; }
  /// Takes what has come; the answer where it is complete. After has_ended() nothing comes any
  /// more, and the point that it had is lost. Throws io::SpecError where it has other inputs.
  std::optional<PointAnswer> listen();
  bool has_ended() const { return has_ended_; }
  bool has_begun() const { return has_begun_; }
  /// Exit code of a process that has ended, if it was not by a signal.
  std::optional<int> exit_code() const;
  /// "its process was ended by signal 9 (Killed)".
  std::string how_it_ended() const;

 private:
  void reap(bool kill);

  std::string fingerprint_;
  pid_t process_ = -1;
  int to_ = -1;
  int from_ = -1;
  std::string bytes_;
  std::optional<std::size_t> point_;
  bool has_begun_ = false;
  bool has_ended_ = false;
  int status_ = 0;
};

}  // namespace torquewright::sweep
