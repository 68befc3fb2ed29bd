// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "base/files/canonical_paths.hpp"
#include "support/temporary_folder.hpp"

using namespace smurf;
namespace fs = std::filesystem;

namespace {

/// file, folder/inner, folder/up -> file, link -> folder, loop -> loop, dead -> nothing.
class Tree : public test::TemporaryFolder {
 public:
  Tree() {
    const Tree& root = *this;
    fs::create_directory(root / "folder");
    std::ofstream(root / "file") << "text";
    std::ofstream(root / "folder/inner") << "text";
    fs::create_directory_symlink("folder", root / "link");
    fs::create_symlink("../file", root / "folder/up");
    fs::create_symlink("loop", root / "loop");
    fs::create_symlink("nothing", root / "dead");
  }
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
                              "file/inner",
                              "",
                              "link/.."};

}  // namespace

TEST_CASE("canonical paths: both calls return the path of std::filesystem") {
  const Tree tree;
  const CanonicalPaths paths;
  for (int look = 0; look < 2; ++look) {
    for (const std::string name : kNames) {
      CAPTURE(name);
      CHECK(paths.of(tree / name) == fs::weakly_canonical(tree / name).string());
    }
  }
}

TEST_CASE("canonical paths: the path of an existing file is that of std::filesystem") {
  const Tree tree;
  for (const std::string name : kNames) {
    CAPTURE(name);
    const fs::path path = tree / name;
    const auto place = canonical_now(path.string());
    CHECK(place.has_value() == fs::exists(path));
    if (place) CHECK(*place == fs::canonical(path).string());
  }
  CHECK(canonical_now(".") == fs::current_path().string());
  CHECK_FALSE(canonical_now(tree / "loop"));
}

TEST_CASE("canonical paths: a link to a missing file is followed") {
  const Tree tree;
  fs::create_symlink("../nothing", tree / "folder/dead");
  const CanonicalPaths paths;
  CHECK(paths.of(tree / "dead") == tree / "nothing");
  CHECK(paths.of(tree / "dead/inner") == tree / "nothing/inner");
  CHECK(paths.of(tree / "link/dead") == tree / "nothing");
}

TEST_CASE("canonical paths: a path through a link continues at the target of the link") {
  const Tree tree;
  fs::create_directories(tree / "a/b");
  fs::create_directory_symlink(tree / "a", tree / "folder/whole");  // absolute, and back again
  fs::create_directory_symlink("../../folder/up", tree / "a/b/twice");
  fs::create_directory_symlink("../link/whole/b", tree / "a/round");
  const CanonicalPaths paths;
  for (const std::string name : {"link/whole/b/twice", "a/round/twice", "a/round/../round/nothing",
                                 "link/whole/../file", "folder/whole/round"}) {
    CAPTURE(name);
    CHECK(paths.of(tree / name) == fs::weakly_canonical(tree / name).string());
  }
}

TEST_CASE("canonical paths: a replaced folder is read again") {
  const Tree tree;
  const CanonicalPaths paths;
  CHECK(paths.of(tree / "folder/inner") == tree / "folder/inner");
  fs::rename(tree / "folder", tree / "old");
  fs::create_directory(tree / "folder");
  fs::create_symlink("../file", tree / "folder/new");
  CHECK(paths.of(tree / "folder/new") == tree / "file");
}

TEST_CASE("canonical paths: a relative path becomes absolute") {
  const CanonicalPaths paths;
  const std::string here = fs::current_path().string();
  CHECK(paths.of("") == fs::canonical(here).string());
  CHECK(paths.of(".") == fs::canonical(here).string());
  CHECK(paths.of("..") == fs::canonical(here).parent_path().string());
  CHECK(paths.of("no such file") == (fs::canonical(here) / "no such file").string());
  CHECK(paths.of("/") == "/");
  CHECK(paths.of("/no such file") == "/no such file");
}

TEST_CASE("canonical paths: links in a circle and too long names have none") {
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
