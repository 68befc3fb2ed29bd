// SPDX-License-Identifier: BSD-3-Clause
// Syntax errors of YAML texts, and their places.
#include <doctest/doctest.h>

#include "support/repeat.hpp"
#include "unit/parsed.hpp"

using namespace smurf;
using smurf::test::check_errors;
using smurf::test::ErrorCase;
using smurf::test::join;
using smurf::test::Lines;
using smurf::test::ParsedYaml;
using smurf::test::repeat;

namespace {

void check(const std::vector<ErrorCase>& cases) { check_errors<ParsedYaml>(cases); }

}  // namespace

TEST_CASE("yaml: duplicate keys are kept and reported at the second") {
  const ParsedYaml parsed("a: 1\nb: 2\na: 3\n\"a\": 4\n");
  CHECK(join(parsed.briefs()) == join({"SML0011 3:1 [a]", "SML0011 4:1 [\"a\"]"}));
  REQUIRE(parsed.document);
  CHECK(parsed.root().size() == 4);
  CHECK(parsed.root().find("a").text() == "1");
  const Diagnostic& diagnostic = parsed.sink.diagnostics().front();
  REQUIRE(diagnostic.labels.size() == 1);
  CHECK(diagnostic.labels.front().span.begin == 0);

  check({{"x: {a: 1, a: 2}\n", {"SML0011 1:11 [a]"}, true},
         {"- {a: 1}\n- {a: 2}\n", {}, true},
         {"~: 1\n'': 2\nnull: 3\n", {}, true},
         {"? {b: 1, b: 2}\n: 1\n", {"SML0012 1:3 [{]", "SML0011 1:10 [b]"}, true}});
}

TEST_CASE("yaml: syntax errors stand at their cause") {
  check({
      {"a: b: c\n", {"SML0010 1:5 [:]"}},
      {"- name elbow\n  joint: elbow\n", {"SML0010 1:3 [name elbow]"}},
      {"a:\n  name elbow\n  joint: elbow\n", {"SML0010 2:3 [name elbow]"}},
      {"name\njoint: elbow\n", {"SML0010 1:1 [name]"}},
      {"- name elbow\n   joint: elbow\n", {"SML0010 2:9 [:]"}},
      {"a:\n\tb: 1\n", {"SML0010 2:1 [\\t]"}},
      {"{\n\t\"a\": 1\n\t\"b\": 2\n}\n", {"SML0010 3:5 [:]"}},
      {"a: [1, 2\n", {"SML0010 1:4 [[]"}},
      {"a:\n- {b: 1\n- {b: 2}\n", {"SML0010 2:3 [{]"}},
      {"a:\n  - 1\n\n  # c\nb\n  - 2\n", {"SML0010 5:1 [b]"}},
      {"a:\n<<<<<<< HEAD\n- 1\n", {"SML0010 2:1 [<<<<<<< HEAD]"}},
      {"a: |\n  text\n\n# comment\n", {}, true},
      {"a:\n  b:\n# comment\n\n", {}, true},
      {"a: [1, 2", {"SML0010 1:4 [[]"}},
      {"a: [", {"SML0010 1:4 [[]"}},
      {"a: {b: 1\n", {"SML0010 1:4 [{]"}},
      {"a: [1, 2\nb: 3\n", {"SML0010 1:4 [[]"}},
      {"- a: [1\n  b: [2]\n", {"SML0010 1:6 [[]"}},
      {"a: [1, 'b' 'c']\n", {"SML0010 1:12 [']"}},
      {"a: {b: '1' 'c'}\n", {"SML0010 1:12 [']"}},
      {"a: [1}\n", {"SML0010 1:6 [}]"}},
      {"a: 'x\n", {"SML0010 1:4 [']"}},
      {"a: 1\n b: 2\n", {"SML0010 2:3 [:]"}},
      {"- a\nb: 1\n", {"SML0010 2:1 [b]"}},
      {"- a\nb\n", {"SML0010 2:1 [b]"}},
      {"a: 1\n<<<<<<< ours\nb: 2\n", {"SML0010 2:1 [<<<<<<< ours]"}},
      {"a: 1\n- b\n", {"SML0010 2:1 [-]"}},
      {"a: *unknown\n", {"SML0010 1:4 [*]"}},
      {"a: @b\n", {"SML0010 1:4 [@]"}},
      {"a: `b\n", {"SML0010 1:4 [`]"}},
      {"a: \"\\q\"\n", {"SML0010 1:5 [\\]"}},
      {"[1,,2]", {"SML0010 1:4 [,]"}},
      {"{,}", {"SML0010 1:2 [,]"}},
      {"[1, 2] ]\n", {"SML0010 1:8 []]"}},
      {"a: ]\n", {"SML0010 1:4 []]"}},
      {"%YAML 1.2\n%YAML 1.2\n---\na: 1\n", {"SML0010 2:1 [%]"}},
  });
}

TEST_CASE("yaml: bytes that no text file may hold") {
  check({
      {std::string("a: 1\0b", 6), {"SML0004 1:5 [" + std::string(1, '\0') + "]"}},
      {"a: \x01\n", {"SML0004 1:4 [\x01]"}},
      {"a: \x7F\n", {"SML0004 1:4 [\x7F]"}},
      {"a: \xFF\n", {"SML0003 1:4 [\xFF]"}},
      {"a: \xC0\x80\n", {"SML0003 1:4 [\xC0]"}},
      {"a: \xED\xA0\x80\n", {"SML0003 1:4 [\xED]"}},
      {"\xFF\xFE"
       "a",
       {"SML0005 1:1 []"}},
  });
}

TEST_CASE("yaml: a list or mapping as key") {
  check({{"? [a]\n: 1\n", {"SML0012 1:3 [[]"}, true},
         {"{[a]: 1}", {"SML0012 1:2 [[]"}, true},
         {"a: &x [1]\n? *x\n: 2\n", {"SML0012 2:3 [*x]"}, true}});
  const ParsedYaml parsed("? [a, {b: c}]\n: 1\nd: 2\n");
  REQUIRE(parsed.document);
  CHECK(join(parsed.lines()) == join({": map [? [a, {b: c}]\\n: 1\\nd: 2]",
                                      "/: [[a, {b: c}]] -> plain [1]", "/d: [d] -> plain [2]"}));
}

TEST_CASE("yaml: a second document is named and dropped") {
  check({
      {"a: 1\n---\nb: 2\n", {"SML0013 2:1 []"}, true},
      {"a: 1\n...\n# c\nb: 2\n", {"SML0013 4:1 []"}, true},
      {"a: 1\n...\n%YAML 1.2\n---\nb: 2\n", {"SML0013 4:1 []"}, true},
      {"a: 1\n---\n", {}, true},
      {"---\na: 1\n...\n", {}, true},
      {"a: 1\n---\n# only a comment\n", {}, true},
      {"a: 1\n---\n'never closed\n", {"SML0013 2:1 []"}, true},
      {"\xEF\xBB\xBF"
       "a: 1\n---\nb: 2\n",
       {"SML0013 2:1 []"},
       true},
  });
}

TEST_CASE("yaml: depth is limited") {
  const Limits limits;
  check({{repeat("[", limits.yaml_depth) + repeat("]", limits.yaml_depth), {}, true},
         {repeat("[", limits.yaml_depth + 1) + repeat("]", limits.yaml_depth + 1),
          {"SML0014 1:101 [[]"}}});
  check({{repeat("[", 100000), {"SML0014 1:101 [[]"}},
         {"a: " + repeat("[x,", 100000), {"SML0014 1:301 [[]"}},
         {repeat("{a: ", 100000), {"SML0014 1:401 [{]"}},
         {"a: '" + repeat("[", 1000) + "'\n", {}, true},
         {"# " + repeat("{", 1000) + "\na: x" + repeat("[", 1000) + "\n", {}, true}});
  std::string block;
  for (std::uint32_t i = 0; i < limits.yaml_depth; ++i) block += repeat(" ", i) + "a:\n";
  check({{block, {}, true},
         {block + repeat(" ", limits.yaml_depth) + "a: 1\n", {"SML0014 101:101 [a]"}}});
}

TEST_CASE("yaml: aliases may not multiply without bound") {
  std::string bomb = "a0: &a0 [x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string below = "*a" + std::to_string(i - 1);
    const std::string name = "a" + std::to_string(i);
    bomb += name + ": &" + name + " [" + below + repeat("," + below, 8) + "]\n";
  }
  const ParsedYaml parsed(bomb);
  CHECK(!parsed.document);
  REQUIRE(parsed.sink.diagnostics().size() == 1);
  CHECK(parsed.sink.diagnostics().front().rule->id == "SML0015");

  Limits tight;
  tight.yaml_expanded_nodes = 2;
  CHECK(ParsedYaml("a: &x [1, 2]\nb: 3\n", tight).document);
  CHECK(ParsedYaml("a: &x [1, 2]\nb: *x\n", tight).briefs().size() == 1);
}

TEST_CASE("yaml: an alias inside its own value") {
  check({{"a: &x [1, *x]\n", {"SML0016 1:11 [*x]"}, true},
         {"&x a: {b: *x}\n", {}, true},
         {"a: &x {b: {c: *x}}\n", {"SML0016 1:15 [*x]"}, true}});
}
