// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"

#include <doctest/doctest.h>

#include <system_error>

#include "base/files/system.hpp"

using namespace smurf;

TEST_CASE("path: parts") {
  struct Row {
    std::string path, parent, name, stem, extension;
  };
  const Row rows[] = {{"", "", "", "", ""},
                      {"a", "", "a", "a", ""},
                      {"a.smurf", "", "a.smurf", "a", ".smurf"},
                      {"x/a.b.yml", "x", "a.b.yml", "a.b", ".yml"},
                      {"/a", "/", "a", "a", ""},
                      {"/", "/", "", "", ""},
                      {"x.d/a", "x.d", "a", "a", ""},
                      {"x/", "x", "", "", ""},
                      {"../a", "..", "a", "a", ""}};
  for (const Row& row : rows) {
    CAPTURE(row.path);
    CHECK(std::string(path::parent(row.path)) == row.parent);
    CHECK(std::string(path::file_name(row.path)) == row.name);
    CHECK(std::string(path::stem(row.path)) == row.stem);
    CHECK(std::string(path::extension(row.path)) == row.extension);
  }
}

TEST_CASE("path: normalize") {
  struct Row {
    std::string path, normal;
  };
  const Row rows[] = {{"", "."},
                      {".", "."},
                      {"./a", "a"},
                      {"a/.", "a"},
                      {"a//b", "a/b"},
                      {"a/../b", "b"},
                      {"a/..", "."},
                      {"..", ".."},
                      {"../..", "../.."},
                      {"a/../..", ".."},
                      {"/", "/"},
                      {"/..", "/"},
                      {"/a/../../b", "/b"},
                      {"//a", "/a"},
                      {"a/", "a"},
                      {"a/b/../../..", ".."},
                      {"../a/../b", "../b"},
                      {"...", "..."},
                      {"a/...", "a/..."},
                      {".a", ".a"},
                      {"a/.b/c", "a/.b/c"},
                      {"a/..b", "a/..b"},
                      {"/a/./b", "/a/b"},
                      {"/.", "/"}};
  for (const Row& row : rows) {
    CAPTURE(row.path);
    CHECK(path::normalize(row.path) == row.normal);
    CHECK(path::normalize(row.normal) == row.normal);
  }
}

TEST_CASE("path: join and relative") {
  struct Row {
    std::string folder, path, joined, relative;
  };
  const Row rows[] = {{"", "a", "a", "a"},
                      {"", "../a", "../a", "../a"},
                      {"x", "a", "x/a", "a"},
                      {"x", "../a", "a", "../a"},
                      {"x/y", "../z/a", "x/z/a", "../z/a"},
                      {"x", "./a", "x/a", "a"},
                      {"/x", "a", "/x/a", "a"},
                      {"x", "..", ".", ".."},
                      {"x", ".", "x", "."},
                      {"../x", "a", "../x/a", "a"},
                      {"/x/y", "../../a", "/a", "../../a"}};
  for (const Row& row : rows) {
    CAPTURE(row.folder);
    CAPTURE(row.path);
    const std::string joined = path::join(row.folder, row.path);
    CHECK(joined == row.joined);
    CHECK(path::relative(joined, row.folder) == row.relative);
  }
  CHECK(path::join("x", "/a") == "/a");
  CHECK(path::relative("/a", "x") == "/a");
  CHECK(path::relative("a", "/x") == "a");
  CHECK(path::relative("a", "..") == "a");
  CHECK(path::relative("../../a", "..") == "../a");
  CHECK(path::relative("x", "x") == ".");
}

TEST_CASE("path: lower case") {
  CHECK(path::to_lower("A.SMURF") == "a.smurf");
  CHECK(path::to_lower("\xC3\x84") == "\xC3\x84");
}

TEST_CASE("path: names that no system opens are left alone") {
  std::string name;
  for (int i = 0; i < 2000; ++i) name += "a/.";
  CHECK(path::normalize(name) == name);
  CHECK(path::join("f", name) == "f/" + name);
  CHECK(path::relative(name, "f") == name);
  CHECK(path::normalize(name.substr(0, 3000)).size() < 3000);
}

TEST_CASE("reasons of the system have the words of Linux") {
  for (int error = 1; error < 134; ++error) {
    CHECK(sys::error_text(error) == std::generic_category().message(error));
  }
}
