// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/draft/import_options.hpp"
#include "robot/loops/general_loop.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// A file's loops that no mechanism of closed form is, on their way into the robot with their own
/// bodies.
class KeptLoops {
 public:
  /// Keeps references.
  KeptLoops(const std::vector<DraftBody>& draft, const DrivenJoints& driven,
            const ImportFileOptions& options)
      : draft_(draft), driven_(driven), options_(options) {}

  /// `why`: what it is not, in a sentence.
  void add(const Connect& connect, std::string why);
  /// Makes loops of all that were added; narrows the ranges of the joints that they move, and adds
  /// a fault for each that is none.
  void make(std::vector<DraftBody>& narrowed, Imported& imported, Faults& faults);
  /// Of all loops, by the drafts' indices.
  std::vector<std::size_t> links() const;
  /// `index`: where in the robot's tree each draft is.
  void put_in_robot(const std::vector<std::size_t>& index, Imported& imported) const;

 private:
  const std::vector<DraftBody>& draft_;
  const DrivenJoints& driven_;
  const ImportFileOptions& options_;
  std::vector<Connect> connects_;
  std::map<const Element*, std::string> why_;
  std::vector<GeneralLoop> loops_;
};

}  // namespace torquewright::hopper
