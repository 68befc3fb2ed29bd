// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "base/files/path_patterns.hpp"

using namespace smurf;

namespace {

PathPatterns patterns(std::string_view text) {
  PathPatterns result;
  result.add_lines(text);
  return result;
}

}  // namespace

TEST_CASE("a name counts at any depth, a path from the folder on") {
  const PathPatterns names = patterns("*.urdf\n");
  CHECK(names.excludes("a.urdf"));
  CHECK(names.excludes("x/y/a.urdf"));
  CHECK_FALSE(names.excludes("a.urdf.xacro"));
  const PathPatterns tied = patterns("/old\nrobots/*/test\n");
  CHECK(tied.excludes("old/a.urdf"));
  CHECK_FALSE(tied.excludes("x/old/a.urdf"));
  CHECK(tied.excludes("robots/arm/test/a.urdf"));
  CHECK_FALSE(tied.excludes("robots/arm/left/test/a.urdf"));
}

TEST_CASE("a pattern that is longer than any path says nothing") {
  const std::string long_class = "[" + std::string(5000, 'b') + "a]";
  CHECK_FALSE(patterns("*" + long_class).excludes("xa"));
  CHECK(patterns("*" + long_class + "\nx*\n").excludes("xa"));
}

TEST_CASE("two stars span folders") {
  const PathPatterns some = patterns("**/test\nlegacy/**\na/**/b\n");
  CHECK(some.excludes("x/y/test"));
  CHECK(some.judge("legacy", true) == PathVerdict::unmentioned);
  CHECK(some.excludes("legacy/x/y"));
  CHECK(some.excludes("a/b"));
  CHECK(some.excludes("a/x/y/b"));
  CHECK_FALSE(some.excludes("x/a/b"));
}

TEST_CASE("a slash at the end means folders, an exclamation mark takes back") {
  const PathPatterns some = patterns("build/\n*.smurf\n!keep.smurf\n");
  CHECK_FALSE(some.excludes("build"));
  CHECK(some.excludes("build/keep.smurf"));  // the folder is excluded
  CHECK(some.excludes("a.smurf"));
  CHECK_FALSE(some.excludes("x/keep.smurf"));
}

TEST_CASE("comments, blanks, escapes and classes") {
  const PathPatterns some = patterns("# a\n\n\\#b\nc  \nd\\ \n[!a-y]1\r\n[z\n\\");
  CHECK_FALSE(some.excludes("# a"));
  CHECK(some.excludes("#b"));
  CHECK(some.excludes("c"));
  CHECK(some.excludes("d "));
  CHECK(some.excludes("z1"));
  CHECK_FALSE(some.excludes("b1"));
  CHECK_FALSE(some.excludes("z"));
}

TEST_CASE("no pattern takes long") {
  PathPatterns some;
  std::string stars;
  for (int i = 0; i < 2000; ++i) stars += "*a";
  some.add(stars + "b");
  some.add("x" + std::string(90, '*') + "/" + stars);
  CHECK_FALSE(some.excludes(std::string(20000, 'a')));
}
