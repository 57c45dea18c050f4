// SPDX-License-Identifier: Apache-2.0
// Work that shows its progress is left after Ctrl-C where another program holds it, and there only.
// Oracle: the signal, and the handler of the test, which stands for that of the other program.
#include "src/report/parts/progress_line.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "src/interrupt.hpp"

namespace torquewright::report {
namespace {

volatile std::sig_atomic_t handled = 0;

extern "C" void count(int) { handled = handled + 1; }

/// Ctrl-C as another program has it.
class ProgressLine : public testing::Test {
 protected:
  ProgressLine() : before_(std::signal(SIGINT, count)) { handled = 0; }
  ~ProgressLine() override { std::signal(SIGINT, before_); }

 private:
  void (*before_)(int);
};

TEST_F(ProgressLine, IsLeftAfterCtrlCInAnotherProgram) {
  const cli::ForwardedInterrupt forwarded;
  report::ProgressLine line;
  EXPECT_NO_THROW(line.show("half"));
  std::raise(SIGINT);
  EXPECT_EQ(handled, 1);  // the other program's own handler
  EXPECT_TRUE(cli::is_interrupted());
  EXPECT_THROW(line.show("more"), cli::Interrupted);
  cli::catch_interrupt();  // a command that ends early does not forget it
  EXPECT_TRUE(cli::is_interrupted());
}

TEST_F(ProgressLine, LeavesTheOtherProgramAsItWas) {
  { const cli::ForwardedInterrupt forwarded; }
  std::raise(SIGINT);
  EXPECT_EQ(handled, 1);
  EXPECT_FALSE(cli::is_interrupted());
  std::raise(SIGINT);
  EXPECT_EQ(handled, 2);
}

TEST_F(ProgressLine, ForgetsTheCtrlCBefore) {
  {
    const cli::ForwardedInterrupt forwarded;
    std::raise(SIGINT);
  }
  const cli::ForwardedInterrupt forwarded;
  EXPECT_FALSE(cli::is_interrupted());
}

TEST_F(ProgressLine, GoesOnWhereTheSignalIsIgnored) {
  std::signal(SIGINT, SIG_IGN);
  const cli::ForwardedInterrupt forwarded;
  std::raise(SIGINT);
  EXPECT_EQ(handled, 0);
  report::ProgressLine line;
  EXPECT_NO_THROW(line.show("all"));
}

TEST_F(ProgressLine, GoesOnWhereTheProgramCatchesItItself) {
  cli::catch_interrupt();
  std::raise(SIGINT);
  EXPECT_TRUE(cli::is_interrupted());
  report::ProgressLine line;
  EXPECT_NO_THROW(line.show("all"));
}

}  // namespace
}  // namespace torquewright::report
