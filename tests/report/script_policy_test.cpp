// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/script_policy.hpp"

#include <gtest/gtest.h>

namespace torquewright::report {
namespace {

// Oracle: printf "alert('Hello, world.');" | openssl dgst -sha256 -binary | base64, the example of
// the W3C's recommendation "Content Security Policy Level 2".
TEST(ScriptPolicy, LetsOneScriptRunAndAsksNoNetwork) {
  const std::string policy = script_policy({"alert('Hello, world.');"});
  EXPECT_NE(policy.find("script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='"),
            std::string::npos)
      << policy;
  EXPECT_TRUE(policy.starts_with("default-src 'none'"));
}

}  // namespace
}  // namespace torquewright::report
