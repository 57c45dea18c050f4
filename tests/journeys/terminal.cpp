// SPDX-License-Identifier: Apache-2.0
#include "tests/journeys/terminal.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace torquewright::journeys {
namespace {

using Words = std::vector<std::string>;
using std::chrono::milliseconds;

constexpr auto kPatience = std::chrono::seconds(120);
constexpr auto kLook = milliseconds(20);
const std::string kPrompt = "$ ";
const std::string kSession = "journey";

/// Runs it without a shell, with nothing of this process's environment; what it prints.
std::string printed_by(Words words) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::string path = "PATH=/usr/local/bin:/usr/bin:/bin", language = "LC_ALL=C.UTF-8";
  std::array<char*, 3> environment{path.data(), language.data(), nullptr};
  pid_t child = -1;
  const int error =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string text;
  std::array<char, 4096> piece;
  for (ssize_t count = 1; error == 0 && count > 0;) {
    count = ::read(ends[0], piece.data(), piece.size());
    if (count > 0) text.append(piece.data(), static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  if (error != 0) throw std::runtime_error(words[0] + " cannot be started");
  int status = 0;
  ::waitpid(child, &status, 0);
  return text;
}

Words rows_in(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

template <typename Holds>
bool waited_for(Holds holds) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

std::filesystem::path made_place() {
  std::string name = (std::filesystem::temp_directory_path() / "terminal-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no folder for a terminal");
  return name;
}

}  // namespace

bool Terminal::is_installed() {
  try {
    return printed_by({"tmux", "-V"}).starts_with("tmux ");
  } catch (const std::runtime_error&) {
    return false;
  }
}

Terminal::Terminal(const std::filesystem::path& folder, const std::filesystem::path& program,
                   int columns, int rows)
    : place_(made_place()) {
  // The shell says after each command that it is done, and how it ended, in a file.
  std::ofstream(place_ / "bashrc") << "PS1='" << kPrompt << "'\nPROMPT_COMMAND='echo $? >> "
                                   << (place_ / "prompts").string() << "'\n"
                                   << "PATH=" << program.parent_path().string() << ":$PATH\n"
                                   << "HISTFILE=\nbind 'set enable-bracketed-paste off'\n"
                                   << "bind 'set bell-style none'\n";
  tmux({"-f",
        "/dev/null",
        "start-server",
        ";",
        "set-option",
        "-g",
        "history-limit",
        "20000",
        ";",
        "new-session",
        "-d",
        "-s",
        kSession,
        "-x",
        std::to_string(columns),
        "-y",
        std::to_string(rows),
        "-c",
        folder.string(),
        "env",
        "-i",
        "PATH=/usr/local/bin:/usr/bin:/bin",
        "LC_ALL=C.UTF-8",
        "TERM=screen",
        "HOME=" + folder.string(),
        "bash",
        "--noprofile",
        "--rcfile",
        (place_ / "bashrc").string(),
        "-i"});
  (void)wait();
}

Terminal::~Terminal() {
  try {
    tmux({"kill-server"});
  } catch (const std::exception&) {  // It is gone already.
  }
  std::error_code ignored;
  std::filesystem::remove_all(place_, ignored);
}

std::string Terminal::tmux(const Words& words) const {
  Words all{"tmux", "-u", "-S", (place_ / "socket").string()};
  all.insert(all.end(), words.begin(), words.end());
  return printed_by(std::move(all));
}

std::size_t Terminal::prompts() const {
  std::ifstream stream(place_ / "prompts");
  return static_cast<std::size_t>(
      std::count(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>(), '\n'));
}

Words Terminal::captured(bool are_joined) const {
  const int history = std::stoi(tmux({"display-message", "-p", "-t", kSession, "#{history_size}"}));
  Words words{"capture-pane", "-p", "-t", kSession, "-S", std::to_string(begin_ - history)};
  if (are_joined) words.emplace_back("-J");
  return rows_in(tmux(words));
}

int Terminal::first_free_row() const {
  std::istringstream stream(
      tmux({"display-message", "-p", "-t", kSession, "#{history_size} #{cursor_y}"}));
  int history = 0, cursor = 0;
  stream >> history >> cursor;
  return history + cursor;
}

void Terminal::type(const std::string& text) const {
  tmux({"send-keys", "-t", kSession, "-l", "--", text});
}

void Terminal::press(const std::string& key) const { tmux({"send-keys", "-t", kSession, key}); }

Words Terminal::shown() const { return rows_in(tmux({"capture-pane", "-p", "-t", kSession})); }

Words Terminal::coloured() const {
  return rows_in(tmux({"capture-pane", "-e", "-p", "-t", kSession}));
}

bool Terminal::comes(const std::string& text) const {
  return waited_for([&] {
    const Words rows = shown();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const std::string& row) { return row.find(text) != std::string::npos; });
  });
}

Screen Terminal::run(const Words& lines) {
  begin_ = first_free_row();
  for (const std::string& line : lines) {
    type(line);
    press("Enter");
  }
  return wait();
}

Screen Terminal::run(const std::string& command, const std::vector<Answer>& answers) {
  begin_ = first_free_row();
  type(command);
  press("Enter");
  for (const auto& [question, typed] : answers) {
    if (!comes(question)) throw std::runtime_error("nobody asks " + question);
    type(typed);
    press("Enter");
  }
  return wait();
}

Screen Terminal::wait() {
  const std::size_t until = prompts_seen_ + 1;
  const std::string prompt = kPrompt.substr(0, kPrompt.size() - 1);
  const bool is_back = waited_for([&] {
    if (prompts() < until) return false;
    const Words rows = shown();
    return !rows.empty() && rows.back() == prompt;
  });
  if (!is_back) {
    std::string window;
    for (const std::string& row : shown()) window += row + "\n";
    throw std::runtime_error("no prompt comes:\n" + window);
  }
  prompts_seen_ = prompts();
  Screen screen;
  std::ifstream stream(place_ / "prompts");
  for (int code = 0; stream >> code;) screen.exit_code = code;
  screen.rows = captured(false);
  screen.lines = captured(true);
  if (!screen.rows.empty()) screen.rows.pop_back();  // the next prompt
  if (!screen.lines.empty()) screen.lines.pop_back();
  return screen;
}

}  // namespace torquewright::journeys
