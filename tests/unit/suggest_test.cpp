// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/suggest.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/findings/rules.hpp"
#include "unit/random.hpp"

using namespace smurf;

TEST_CASE("suggest: distance") {
  struct Row {
    std::string a;
    std::string b;
    int distance;
  };
  const Row rows[] = {
      {"", "", 0},           {"a", "", 1},         {"abc", "abc", 0},       {"abc", "abd", 1},
      {"abc", "ab", 1},      {"abc", "abcd", 1},   {"abc", "acb", 1},       {"abc", "cba", 2},
      {"elbow", "ELBOW", 1}, {"elbow", "Elbw", 2}, {"kitten", "sitting", 3}};
  for (const Row& row : rows) {
    CAPTURE(row.a);
    CAPTURE(row.b);
    CHECK(edit_distance(row.a, row.b, 10) == row.distance);
    CHECK(edit_distance(row.b, row.a, 10) == row.distance);
    if (row.distance > 1) CHECK(edit_distance(row.a, row.b, row.distance - 1) == row.distance);
  }
  CHECK(edit_distance("abcdef", "uvwxyz", 2) == 3);
  CHECK(edit_distance("a", "abcdef", 2) == 3);
}

TEST_CASE("suggest: the band changes nothing") {
  // The textbook table, without limit.
  const auto plain = [](const std::string& a, const std::string& b) {
    std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
      for (std::size_t j = 0; j <= b.size(); ++j) {
        int& best = cost[i][j] = static_cast<int>(i == 0 ? j : i);
        if (i == 0 || j == 0) continue;
        best = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1,
                         cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
        if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
          best = std::min(best, cost[i - 2][j - 2] + 1);
        }
      }
    }
    return cost[a.size()][b.size()];
  };
  MESSAGE("seed " << test::seed());
  test::Random random;
  const auto word = [&] {
    std::string text;
    for (std::size_t size = random.below(9); size > 0; --size) text += "abc"[random.below(3)];
    return text;
  };
  for (int round = 0; round < 20000; ++round) {
    const std::string a = word();
    const std::string b = word();
    const std::vector<std::string_view> known{b};
    const bool is_near =
        a != b && !a.empty() && plain(a, b) <= std::max<int>(1, static_cast<int>(a.size()) / 3);
    CHECK(nearest(a, known).has_value() == is_near);
    const int limit = static_cast<int>(random.below(6));
    const int expected = std::min(plain(a, b), limit + 1);
    if (edit_distance(a, b, limit) == expected) continue;
    CAPTURE(a);
    CAPTURE(b);
    CAPTURE(limit);
    CHECK(edit_distance(a, b, limit) == expected);
    break;
  }
}

TEST_CASE("suggest: an index changes nothing") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  const auto word = [&](std::size_t most) {
    std::string text;
    for (std::size_t size = 1 + random.below(most); size > 0; --size)
      text += "abA1_"[random.below(5)];
    return text;
  };
  for (int round = 0; round < 30; ++round) {
    const std::size_t longest = 2 + random.below(11);
    std::vector<std::string> names;
    for (int i = 0; i < 150; ++i) names.push_back(word(longest));
    const std::vector<std::string_view> known(names.begin(), names.end());
    std::uint64_t steps = 1'000'000'000;  // of one sink, which searches again and again
    SuggestionIndexes indexes;
    for (int search = 0; search < 60; ++search) {
      const std::string name =
          random.below(2) == 0 ? word(longest) : names[random.below(150)] + "a";
      CAPTURE(name);
      CHECK(only_nearest(name, known, steps, &indexes) == only_nearest(name, known));
    }
  }
}

TEST_CASE("suggest: many misspelt names of many take linear time") {
  const auto steps_for = [](int count) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) names.push_back("link_" + std::to_string(i));
    const std::vector<std::string_view> known(names.begin(), names.end());
    constexpr std::uint64_t kSteps = 1'000'000'000;
    std::uint64_t steps = kSteps;
    SuggestionIndexes indexes;
    for (int i = 0; i < count; ++i) {
      const auto near = only_nearest("lnk_" + std::to_string(i), known, steps, &indexes);
      CHECK((near && *near == names[static_cast<std::size_t>(i)]));
    }
    return kSteps - steps;
  };
  CHECK(steps_for(20000) < 15 * steps_for(2000));
}

TEST_CASE("suggest: not the thing itself") {
  const std::vector<std::string_view> known = {"finger_joint", "finger_joing", "drive"};
  CHECK(!only_nearest("finger_joi", known));
  const auto others = without_own("finger_joi", "finger_joint", known);
  REQUIRE(others);
  CHECK(only_nearest("finger_joi", *others) == "finger_joing");
  CHECK(!without_own("finger_joi", "drive", known));
}

TEST_CASE("suggest: the nearest name") {
  const std::vector<std::string_view> known = {"shoulder", "elbow", "elbow_2", "wrist", "EE"};
  struct Row {
    std::string name;
    std::string nearest;  // empty: none
  };
  const Row rows[] = {{"elbo", "elbow"}, {"Elbow", "elbow"},       {"elbow_1", "elbow_2"},
                      {"elbow", ""},     {"shuolder", "shoulder"}, {"gripper", ""},
                      {"", ""},          {"wirst", "wrist"},       {"ee", "EE"},
                      {"x", ""},         {"SHOULDER", "shoulder"}};
  for (const Row& row : rows) {
    CAPTURE(row.name);
    CHECK(std::string(nearest(row.name, known).value_or("")) == row.nearest);
  }
  const std::vector<std::string_view> ties = {"joint_a", "joint_b"};
  const std::vector<std::string_view> letters{"a", "c", "b"};
  CHECK(nearest("B", letters) == "b");
  CHECK(nearest("joint_c", ties) == "joint_a");
  CHECK(!only_nearest("joint_c", ties));
  CHECK(only_nearest("joint_aa", ties) == "joint_a");
  CHECK(only_nearest("Joint_b", ties) == "joint_b");
  CHECK(only_nearest("joint_c", std::vector<std::string_view>{"joint_a", "joint_a"}) == "joint_a");
  CHECK(!only_nearest("elbow", std::vector<std::string_view>{"Elbow", "ELBOW"}));
  CHECK(!nearest("a", {}));
  CHECK(!nearest(std::string(100000, 'a'), known));
}

TEST_CASE("suggest: one bound for all suggestions of a sink, and a note that tells of it") {
  const std::vector<std::string_view> known = {"elbow", "shoulder"};
  DiagnosticSink sink(10'000, 1000);
  int suggested = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    sink.report(rules::sml0010_yaml_syntax, {SourceId{0}, i, i}, "a name is misspelt");
    if (sink.suggest("elbwo", known)) ++suggested;
  }
  CHECK(suggested > 1);
  CHECK(suggested < 100);
  const std::vector<Diagnostic> all = sink.take();
  REQUIRE(all.size() == 100);
  // The first finding without a suggestion tells it.
  const Diagnostic& last = all[static_cast<std::size_t>(suggested)];
  REQUIRE(last.notes.size() == 1);
  CHECK(last.notes[0].starts_with("from here on, no names are suggested"));
  CHECK(last.notes[0].ends_with("raise the limit with `--limit suggestions=N`"));
}

TEST_CASE("suggest: nothing for a finding that is left out") {
  const std::vector<std::string_view> known = {"elbow"};
  DiagnosticSink sink(1);
  for (const bool is_kept : {true, false}) {
    sink.report(rules::sml0010_yaml_syntax, {}, "a name is misspelt");
    CHECK(sink.suggest("elbwo", known).has_value() == is_kept);
  }
}
