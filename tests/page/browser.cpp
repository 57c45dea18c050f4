// SPDX-License-Identifier: Apache-2.0
#include "tests/page/browser.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace torquewright::page_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kPatience_ms = 60000;
constexpr int kKeyCodeOfSpace = 32;

struct Pipe {
  std::array<int, 2> ends{};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
};

/// In the child: never returns. Both pipes are first moved out of the way of 3 and 4.
[[noreturn]] void become_browser(const fs::path& program, const fs::path& profile, int in, int out,
                                 Browser::Depth depth) {
  const int quiet = ::open("/dev/null", O_RDWR);
  const int in_kept = ::fcntl(in, F_DUPFD, 10);
  const int out_kept = ::fcntl(out, F_DUPFD, 10);
  ::dup2(quiet, STDOUT_FILENO);
  ::dup2(quiet, STDERR_FILENO);
  ::dup2(in_kept, 3);
  ::dup2(out_kept, 4);
  std::vector<std::string> words{
      program.string(),
      "--headless",
      "--no-sandbox",
      "--disable-gpu",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-dev-shm-usage",
      "--remote-debugging-pipe",
      "--user-data-dir=" + profile.string(),
      depth == Browser::Depth::kNone ? "--disable-3d-apis" : "--enable-unsafe-swiftshader"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(arguments.front(), arguments.data());
  ::_exit(126);
}

}  // namespace

fs::path chromium() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const fs::path program = fs::path(folder) / name;
      if (::access(program.c_str(), X_OK) == 0) return program;
    }
  }
  return {};
}

Browser::Browser(Depth depth) {
  const fs::path program = chromium();
  const Pipe commands;
  const Pipe answers;
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ == 0) {
    become_browser(program, profile_.path(), commands.ends[0], answers.ends[1], depth);
  }
  ::close(commands.ends[0]);
  ::close(answers.ends[1]);
  to_ = commands.ends[1];
  from_ = answers.ends[0];
  const json target = call("Target.createTarget", {{"url", "about:blank"}});
  session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})
                 .at("sessionId");
  for (const char* domain : {"Page", "Runtime", "Log", "Network", "Accessibility"}) {
    call(std::string(domain) + ".enable");
  }
}

Browser::~Browser() {
  ::close(to_);
  ::close(from_);
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

json Browser::next_message() {
  for (std::size_t end = read_.find('\0'); true; end = read_.find('\0')) {
    if (end != std::string::npos) {
      const json message = json::parse(read_.substr(0, end));
      read_.erase(0, end + 1);
      return message;
    }
    pollfd waits{from_, POLLIN, 0};
    if (::poll(&waits, 1, kPatience_ms) <= 0) throw std::runtime_error("the browser is silent");
    std::array<char, 65536> bytes{};
    const ssize_t count = ::read(from_, bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error("the browser has ended");
    read_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

void Browser::note_event(const json& message) {
  const std::string method = message.value("method", "");
  if (method == "Page.loadEventFired") is_loaded_ = true;
  if (method == "Network.requestWillBeSent") {
    requests_.push_back(message["params"]["request"]["url"]);
  }
  // How fast the processor draws is no complaint about the page.
  const bool is_of_drawing =
      method == "Log.entryAdded" && message["params"]["entry"].value("source", "") == "rendering";
  if (method == "Runtime.exceptionThrown" || (method == "Log.entryAdded" && !is_of_drawing)) {
    complaints_.push_back(message["params"].dump());
  }
}

json Browser::call(const std::string& method, const json& parameters) {
  const int id = ++calls_;
  json message{{"id", id}, {"method", method}};
  message["params"] = parameters.is_null() ? json::object() : parameters;
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(to_, text.data() + sent, text.size() - sent);
    if (count <= 0) throw std::runtime_error("the browser does not listen");
    sent += static_cast<std::size_t>(count);
  }
  for (;;) {
    const json answer = next_message();
    if (answer.value("id", 0) != id) {
      note_event(answer);
      continue;
    }
    if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
    return answer.at("result");
  }
}

void Browser::open(const fs::path& file, int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 500}});
  requests_.clear();
  complaints_.clear();
  is_loaded_ = false;
  call("Page.navigate", {{"url", "file://" + file.string()}});
  while (!is_loaded_) note_event(next_message());
}

void Browser::allow_scripts(bool allowed) {
  call("Emulation.setScriptExecutionDisabled", {{"value", !allowed}});
}

json Browser::value_of(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails")) {
    throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
  }
  return answer["result"].value("value", json());
}

void Browser::press(const std::string& key) {
  json event{{"key", key}, {"code", key}};
  if (key == " ") {
    event.update({{"code", "Space"}, {"text", " "}, {"windowsVirtualKeyCode", kKeyCodeOfSpace}});
  } else if (key == "Tab") {
    event["windowsVirtualKeyCode"] = 9;
  } else if (key == "End") {
    event["windowsVirtualKeyCode"] = 35;
  } else if (key == "ArrowRight") {
    event["windowsVirtualKeyCode"] = 39;
  }
  for (const char* type : {"keyDown", "keyUp"}) {
    event["type"] = type;
    call("Input.dispatchKeyEvent", event);
  }
}

void Browser::click(double x, double y) {
  for (const char* type : {"mousePressed", "mouseReleased"}) {
    call("Input.dispatchMouseEvent",
         {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"clickCount", 1}});
  }
}

void Browser::drag(double from_x, double from_y, double to_x, double to_y) {
  const auto mouse = [this](const char* type, double x, double y, int buttons) {
    call("Input.dispatchMouseEvent", {{"type", type},
                                      {"x", x},
                                      {"y", y},
                                      {"button", "left"},
                                      {"buttons", buttons},
                                      {"clickCount", 1}});
  };
  mouse("mousePressed", from_x, from_y, 1);
  for (int i = 1; i <= 4; ++i) {
    mouse("mouseMoved", from_x + i * (to_x - from_x) / 4, from_y + i * (to_y - from_y) / 4, 1);
  }
  mouse("mouseReleased", to_x, to_y, 0);
}

void Browser::point(double x, double y) {
  call("Input.dispatchMouseEvent", {{"type", "mouseMoved"}, {"x", x}, {"y", y}});
}

void Browser::prefer_dark(bool dark) {
  call("Emulation.setEmulatedMedia",
       {{"features", {{{"name", "prefers-color-scheme"}, {"value", dark ? "dark" : "light"}}}}});
}

bool Browser::wait_for(const std::string& expression) {
  for (int i = 0; i < 200; ++i) {
    if (value_of(expression) == true) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

}  // namespace torquewright::page_test
