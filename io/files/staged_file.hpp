// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace torquewright::io {

/// Where an output goes to: the path with links followed. Throws SpecError for what no content can
/// replace: a folder, a link to nothing, an input of this session.
struct Target {
  explicit Target(const std::filesystem::path& the_file);

  std::filesystem::path file;  ///< As the user named it.
  std::filesystem::path path;
  bool exists = false;
  bool is_direct = false;  ///< A pipe, a device, a descriptor: written into, not replaced.
};

/// Throws SpecError where the target could not be replaced, as far as that shows without trying.
void require_writable(const Target& target);

/// Content under way to its file. It has no name yet, where the file system can hold it so: if the
/// program is killed, nothing is left of it. Each step throws SpecError where it fails.
class StagedFile {
 public:
  /// Gives a long text piece by piece.
  using Source = std::function<void(const std::function<void(std::string_view)>& sink)>;

  /// Requires a target that is not direct. `more` follows the content; it may be null.
  StagedFile(Target target, std::string_view content, Source more = nullptr);
  StagedFile(StagedFile&& other) noexcept;
  ~StagedFile();

  /// Writes the content, under no name or a temporary one.
  void stage();
  /// Gives it the file's name, mode and owner.
  void publish();
  /// Puts back what stood there before publish(), where the file system knows a way back.
  void withdraw();

 private:
  enum class Published { kNot, kNew, kExchanged, kForGood };

  void open();
  bool takes_name(const std::filesystem::path& name) const;
  void give_temporary_name();
  void keep_owner_and_mode() const;

  Target target_;
  std::string_view content_;
  Source more_;
  std::filesystem::path temporary_ = {};  ///< Empty: there is none.
  int descriptor_ = -1;
  Published published_ = Published::kNot;
};

}  // namespace torquewright::io
