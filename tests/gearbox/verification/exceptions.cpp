// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/verification/exceptions.hpp"

#include <algorithm>

namespace torquewright::gearbox::verification_test {
namespace {

using Json = nlohmann::json;

bool has_fewer_designs_than_asked_for(const Json& before) {
  return before["status"] == "infeasible" ||
         before["certificate"]["claims"][0]["reference"].is_null();
}
bool ended_without_design(const Json& before) {
  return before["status"] == "limit" && before["designs"].empty();
}

}  // namespace

const std::vector<Exception>& exceptions() {
  static const std::regex any(".*");
  static const std::regex swap("swap with next");
  static const std::vector<Exception> all = {
      {"`/tool/version`",
       "any version's result is checked alike; another version than the checker's own is said to "
       "be "
       "unchecked",
       std::regex("/tool/version"), std::regex("say .*")},
      {"`/inputs/0/path`",
       "where there is no such file, the problem is not compared, and this is said",
       std::regex("/inputs/0/path"), std::regex("say .*")},
      {"`/search/seconds`",
       "the time leaves no trace in a proof; any that is not negative is taken",
       std::regex("/search/seconds"), any},
      {"`/search/relaxations`",
       "a solve that closed no box leaves no trace; more than boxes, and none where one was "
       "closed, "
       "are refused",
       std::regex("/search/relaxations"), any},
      {"`/options/relaxation`",
       "how the search was steered: a proof stands without it; `never` with solves is refused",
       std::regex("/options/relaxation"), any},
      {"`/options/time_limit_s`", "likewise; any time above zero is taken",
       std::regex("/options/time_limit_s"), any},
      {"`/options/max_nodes`", "likewise; fewer than the boxes of the proof are refused",
       std::regex("/options/max_nodes"), any},
      {"`/options/top` where there are fewer designs, or none",
       "the K best are the same for every K that is greater", std::regex("/options/top"), any,
       has_fewer_designs_than_asked_for},
      {"`/bound` of a search that ended without a design",
       "a weaker bound is true as well; with a design the gap would not fit", std::regex("/bound"),
       any, ended_without_design},
      {"`/held_fixed` and `/not_asked` left out", "results of before 0.2.0 do not say it",
       std::regex("/(held_fixed|not_asked)"), std::regex("remove key")},
      {"order of `/conflict`", "it is a set", std::regex("/conflict/[0-9]+"), swap},
      {"order of a claim's `constraints`", "they are a set",
       std::regex("/certificate/claims/[0-9]+/constraints/[0-9]+"), swap},
      {"order of a claim's `alternatives`", "each says itself which it is",
       std::regex("/certificate/claims/[0-9]+/alternatives/[0-9]+"), swap},
      {"order of `/ties`", "they are equally good", std::regex("/ties/[0-9]+"), swap},
      {"order of `/designs` that are equally good",
       "it says nothing; the last one is the reference", std::regex("/designs/[0-9]+"), swap},
  };
  return all;
}

const Exception* find_exception(const proof_test::Mutation& mutation, const Json& before) {
  const auto covers = [&](const Exception& each) {
    return std::regex_match(mutation.pointer, each.pointer) &&
           std::regex_match(mutation.kind, each.kind) &&
           (each.applies == nullptr || each.applies(before));
  };
  const auto found = std::find_if(exceptions().begin(), exceptions().end(), covers);
  return found == exceptions().end() ? nullptr : &*found;
}

}  // namespace torquewright::gearbox::verification_test
