// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/files/journal_file.hpp"
#include "src/sweep/request.hpp"

namespace torquewright::sweep {

/// A sweep's answers in a file, one JSON object a line: {"point": name, "request": SHA-256, "row":
/// ...} or {..., "lost": why}. It may hold those of other requests.
class Journal {
 public:
  /// None is kept where the request names no file. Throws io::SpecError, as io::JournalFile.
  explicit Journal(const Request& request);

  /// The answer that the journal holds already for each point; none for points that were lost.
  std::vector<std::optional<Answer>> known() const;
  /// Is kept when this returns.
  void add(const PointAnswer& answer);

 private:
  const Request& request_;
  std::unique_ptr<io::JournalFile> file_;
};

/// The answer as it would be read from a journal, so that a sweep that went on says the same as one
/// that did not; what is no JSON is lost.
Answer as_kept(Answer answer);

/// For before the work: throws io::SpecError where no journal could be kept in that file.
void check_journal(const std::string& file);

}  // namespace torquewright::sweep
