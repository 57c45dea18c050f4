// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::page_test {

/// Chromium's program; empty where none is installed.
std::filesystem::path chromium();

/// A headless Chromium with one page, driven through its debugging pipe (Chrome DevTools Protocol:
/// messages of JSON that end in a zero byte, to its descriptor 3, from its descriptor 4).
class Browser {
 public:
  /// Whether the browser draws in three dimensions, with the processor.
  enum class Depth { kWebGl, kNone };
  /// Requires that there is one.
  explicit Browser(Depth depth = Depth::kWebGl);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Loads the file in a window of that size.
  void open(const std::filesystem::path& file, int width, int height);
  void allow_scripts(bool allowed);

  /// What a JavaScript expression of the page is worth. Throws with its words where it fails.
  nlohmann::json value_of(const std::string& expression);
  /// A key as a person presses it, at what has the focus; `key` as KeyboardEvent calls it.
  void press(const std::string& key);
  /// The left button, at that place of the window.
  void click(double x, double y);
  /// The left button down at one place, moved, and up at another.
  void drag(double from_x, double from_y, double to_x, double to_y);
  /// The pointer moved there, no button down.
  void point(double x, double y);
  void prefer_dark(bool dark);
  /// Until the expression is true. False: not within ten seconds.
  bool wait_for(const std::string& expression);

  /// Every address that the page asked for, its own first.
  const std::vector<std::string>& requests() const { return requests_; }
  /// Exceptions of its script, and what the browser logged of it.
  const std::vector<std::string>& complaints() const { return complaints_; }

  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = {});

 private:
  nlohmann::json next_message();
  void note_event(const nlohmann::json& message);

  test::ScratchFolder profile_;
  pid_t process_ = -1;
  int to_ = -1;
  int from_ = -1;
  int calls_ = 0;
  bool is_loaded_ = false;
  std::string session_;
  std::string read_;
  std::vector<std::string> requests_;
  std::vector<std::string> complaints_;
};

}  // namespace torquewright::page_test
