// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "tests/cli/workplace.hpp"
#include "tests/page/browser.hpp"

namespace torquewright::page_test {

/// A page that a command wrote once for all tests of a suite, and a browser to open it in. A suite
/// writes its page in SetUpTestSuite(); where no Chromium is installed its tests are skipped.
class WrittenPage : public testing::Test {
 protected:
  /// Runs a command that writes page.html into place(), once files are there that it reads. What is
  /// not about the view that turns is tested without it: it is drawn by the processor here.
  static void write_page(const std::vector<std::string>& command,
                         Browser::Depth depth = Browser::Depth::kNone) {
    const auto outcome = place_->run(command);
    ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
    browser_ = std::make_unique<Browser>(depth);
  }
  /// False where there is no browser, and nothing is to be written.
  static bool has_browser() {
    if (chromium().empty()) return false;
    place_ = std::make_unique<cli_test::Workplace>();
    return true;
  }
  static void TearDownTestSuite() {
    browser_.reset();
    place_.reset();
  }
  void SetUp() override {
    if (chromium().empty()) GTEST_SKIP() << "Chromium is not installed (Debian: chromium)";
  }

  static cli_test::Workplace& place() { return *place_; }
  static Browser& browser() { return *browser_; }
  static void open(int width) { browser_->open(place_->path("page.html"), width, 900); }

 private:
  static inline std::unique_ptr<cli_test::Workplace> place_;
  static inline std::unique_ptr<Browser> browser_;
};

}  // namespace torquewright::page_test
