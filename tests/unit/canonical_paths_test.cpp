// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "base/canonical_paths.hpp"

using namespace smurf;
namespace fs = std::filesystem;

namespace {

/// A folder of its own: file, folder/inner, link -> folder, loop -> loop, dead -> nothing.
class Tree {
 public:
  Tree() {
    std::string pattern = fs::canonical(fs::temp_directory_path()) / "smurf_test_XXXXXX";
    root_ = ::mkdtemp(pattern.data());
    fs::create_directory(root_ / "folder");
    std::ofstream(root_ / "file") << "text";
    std::ofstream(root_ / "folder/inner") << "text";
    fs::create_directory_symlink("folder", root_ / "link");
    fs::create_symlink("../file", root_ / "folder/up");
    fs::create_symlink("loop", root_ / "loop");
    fs::create_symlink("nothing", root_ / "dead");
  }
  ~Tree() { fs::remove_all(root_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  std::string operator/(const std::string& name) const { return (root_ / name).string(); }

 private:
  fs::path root_;
};

const char* const kNames[] = {"file",
                              "folder",
                              "folder/",
                              "folder/.",
                              "folder/..",
                              "folder/inner",
                              "link",
                              "link/inner",
                              "link/up",
                              "link/../file",
                              "folder//inner",
                              "./file",
                              "nothing",
                              "nothing/at/all",
                              "nothing/../file",
                              "folder/nothing/../inner",
                              "dead",
                              "dead/inner",
                              "file/inner",
                              "",
                              "link/.."};

}  // namespace

TEST_CASE("canonical paths: what the standard library says, at the first look and the second") {
  const Tree tree;
  const CanonicalPaths paths;
  for (int look = 0; look < 2; ++look) {
    for (const std::string name : kNames) {
      CAPTURE(name);
      CHECK(paths.of(tree / name) == fs::weakly_canonical(tree / name).string());
    }
  }
}

TEST_CASE("canonical paths: relative ones are absolute afterwards") {
  const CanonicalPaths paths;
  const std::string here = fs::current_path().string();
  CHECK(paths.of("") == fs::canonical(here).string());
  CHECK(paths.of(".") == fs::canonical(here).string());
  CHECK(paths.of("..") == fs::canonical(here).parent_path().string());
  CHECK(paths.of("no such file") == (fs::canonical(here) / "no such file").string());
  CHECK(paths.of("/") == "/");
  CHECK(paths.of("/no such file") == "/no such file");
}

TEST_CASE("canonical paths: links in a circle and names that are too long have none") {
  const Tree tree;
  const CanonicalPaths paths;
  CHECK(!paths.of(tree / "loop"));
  CHECK(!paths.of(tree / "loop/inner"));
  std::string deep = tree / "folder";
  for (int i = 0; i < 100'000; ++i) deep += "/a";
  CHECK(!paths.of(deep));
}

TEST_CASE("canonical paths: several threads") {
  const Tree tree;
  const CanonicalPaths paths;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (const std::string name : kNames) static_cast<void>(paths.of(tree / name));
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(paths.of(tree / "link/inner") == tree / "folder/inner");
}
