// SPDX-License-Identifier: BSD-3-Clause
#include "base/suggest.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

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
  CHECK(nearest("joint_c", ties) == "joint_a");
  CHECK(!nearest("a", {}));
  CHECK(!nearest(std::string(100000, 'a'), known));
}
