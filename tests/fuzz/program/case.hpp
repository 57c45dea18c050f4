// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace torquewright::fuzz {

using Words = std::vector<std::string>;

/// Something that stands in the folder before the program runs.
struct Thing {
  enum class Kind {
    kFile,
    kReadOnlyFile,
    kFolder,
    kPipe,      ///< Named, with somebody who reads what comes.
    kLink,      ///< Symbolic.
    kHardLink,  ///< Another name of a file.
  };
  Kind kind = Kind::kFile;
  std::string content;  ///< A file's bytes; where a link leads.
};

/// One run of the program: its arguments, and by their paths the things that differ from the
/// examples of the repository, among which it runs.
struct Case {
  Words arguments;
  std::map<std::string, Thing> things;
};

}  // namespace torquewright::fuzz
