// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/journeys/journey.hpp"

namespace torquewright::journeys {

/// The window of the tests: as narrow as windows commonly are.
inline constexpr int kColumns = 80;
inline constexpr int kRows = 30;

/// What a window showed of one command.
struct Screen {
  int exit_code = -1;
  std::vector<std::string> rows;   ///< As they stand in the window.
  std::vector<std::string> lines;  ///< The same, with rows that the window broke put together.
};

/// A window with a shell in it, held by tmux: a terminal emulator without a screen. Of its own:
/// socket, settings and shell's settings are nobody else's. Everything waits with a bound.
class Terminal {
 public:
  static bool is_installed();

  /// `program` can be called by its name. Throws std::runtime_error where no prompt comes.
  Terminal(const std::filesystem::path& folder, const std::filesystem::path& program, int columns,
           int rows);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Types the lines, the last one's Enter too, and waits for the prompt. Throws where none comes.
  Screen run(const std::vector<std::string>& lines);
  /// Types a command, and each answer when its question has come. Throws where none comes.
  Screen run(const std::string& command, const std::vector<Answer>& answers);
  /// Types without Enter.
  void type(const std::string& text) const;
  /// A key by tmux' name: Tab, Enter, C-c.
  void press(const std::string& key) const;
  /// All rows that the window shows now, without the empty ones below.
  std::vector<std::string> shown() const;
  /// The same with the escapes that colour them.
  std::vector<std::string> coloured() const;
  /// Waits until a row holds the text. False: it does not come.
  bool comes(const std::string& text) const;
  /// Waits for the prompt that follows what was typed. Throws where none comes.
  Screen wait();

 private:
  std::string tmux(const std::vector<std::string>& words) const;
  std::vector<std::string> captured(bool are_joined) const;
  int first_free_row() const;
  std::size_t prompts() const;

  std::filesystem::path place_;  ///< Of socket and counter.
  std::size_t prompts_seen_ = 0;
  int begin_ = 0;  ///< Row, from the first ever, at which what was typed last begins.
};

}  // namespace torquewright::journeys
