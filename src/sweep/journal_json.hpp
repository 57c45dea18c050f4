// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/files/journal_file.hpp"
#include "src/sweep/request.hpp"

namespace torquewright::sweep {

/// A sweep's answers in a file, one JSON object a line: {"point": name, "request": SHA-256, "row":
/// ...} or {..., "lost": why}. It may hold those of other requests. Where several processes write
/// it, one run of them all says in each line which it is ("run"), and says {..., "begun": true} of
/// a point that one of them does.
class Journal {
 public:
  /// None is kept where the request names no file. `run` names the run that several processes are,
  /// where they share the journal. Throws io::SpecError, as io::JournalFile.
  explicit Journal(const Request& request, const std::string& run = "");

  /// The answer that the journal holds for each point. Points that were lost have none, but for
  /// those of this run of several.
  const std::vector<std::optional<Answer>>& known() const { return known_; }
  /// Adds an answer, which is kept when this returns.
  void add(const PointAnswer& answer);

  /// Claims a point without an answer for this process alone, and says that it has begun; none
  /// where there is none, or another process does each. Of a run of several. A point that was begun
  /// by a process that is gone is lost: that is known, and kept, when this returns.
  std::optional<std::size_t> claim();

 private:
  void read_on();
  void read(const std::string& line);
  void write(std::size_t point, const char* key, const std::string& json);

  const Request& request_;
  std::string run_;
  std::unique_ptr<io::JournalFile> file_;
  std::map<std::string, std::size_t> points_;  ///< By their names.
  std::size_t read_ = 0;                       ///< Lines of the file that known_ holds.
  std::vector<std::optional<Answer>> known_;
  std::vector<bool> is_begun_;  ///< In this run.
};

/// The answer as it would be read from a journal, so that a sweep that went on says the same as one
/// that did not; what is no JSON is lost.
Answer as_kept(Answer answer);

/// Checks before the work: throws io::SpecError where no journal could be kept in that file, or
/// where it is not one that ranks of mpirun may share.
void check_journal(const std::string& file);

}  // namespace torquewright::sweep
