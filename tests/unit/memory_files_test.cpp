// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "smurf/file_reader.hpp"
#include "support/temporary_folder.hpp"

using namespace smurf;

namespace {

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("files: in memory") {
  MemoryFiles files;
  files.add("a/./b/../x.yml", "one");
  files.add("a/y.yml", "");
  files.add("top.smurf", "t");
  files.add("/abs/z", "z");

  CHECK(files.read("a/x.yml", 3).text == "one");
  CHECK(files.read("./a//x.yml", 3).status == ReadStatus::ok);
  CHECK(files.read("a/x.yml", 2).status == ReadStatus::too_large);
  CHECK(files.read("a/y.yml", 0).status == ReadStatus::ok);
  CHECK(files.read("a", 9).status == ReadStatus::not_found);
  CHECK(files.is_file("a/x.yml"));
  CHECK(!files.is_file("a"));
  CHECK(files.list("a") == Names{"x.yml", "y.yml"});
  CHECK(files.list("") == Names{"a", "top.smurf"});
  CHECK(files.list(".") == Names{"a", "top.smurf"});
  CHECK(files.list("/abs") == Names{"z"});
  CHECK(files.list("none").empty());
  files.add("a/y.yml", "again");
  CHECK(files.read("a/y.yml", 9).text == "again");
}

TEST_CASE("files: memory in front of others") {
  MemoryFiles behind;
  behind.add("a", "behind");
  behind.add("b", "behind");
  MemoryFiles files(&behind);
  files.add("a", "front");
  CHECK(files.read("a", 99).text == "front");
  CHECK(files.read("b", 99).text == "behind");
  CHECK(files.is_file("b"));
  CHECK(!files.is_file("c"));
  CHECK(files.list("") == Names{"a", "b"});
}

TEST_CASE("files: on disk") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "a.yml") << "text";
  std::ofstream(folder / "empty");
  std::filesystem::create_directory(folder / "sub");
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const DiskFiles files;

  CHECK(files.read(folder / "a.yml", 4).text == "text");
  CHECK(files.read(folder / "a.yml", 3).status == ReadStatus::too_large);
  CHECK(files.read(folder / "empty", 0).status == ReadStatus::ok);
  CHECK(files.read(folder / "none", 9).status == ReadStatus::not_found);
  CHECK(files.read(folder / "a.yml/x", 9).status == ReadStatus::not_found);
  CHECK(files.read(folder / "sub", 9).status == ReadStatus::not_a_file);
  CHECK(files.read(folder / "pipe", 9).status == ReadStatus::not_a_file);
  CHECK(files.read("/dev/zero", 9).status == ReadStatus::not_a_file);
  CHECK(files.read("", 9).status == ReadStatus::not_found);
  CHECK(files.read(std::string("a\0b", 3), 9).status == ReadStatus::not_found);
  CHECK(files.read(folder / std::string(5000, 'x'), 9).status != ReadStatus::ok);
  CHECK(files.is_file(folder / "a.yml"));
  CHECK(!files.is_file(folder / "sub"));
  CHECK(!files.is_file(folder / "pipe"));
  CHECK(!files.is_file(std::string("/dev/null\0", 10)));
  CHECK(files.list(folder / "") == Names{"a.yml", "empty", "pipe", "sub"});
  CHECK(files.list(folder / "none").empty());
}

TEST_CASE("files: confined to a folder") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "in");
  for (const char* name : {"in/a", "out", "inside"}) std::ofstream(folder / name) << name;
  std::filesystem::create_symlink(folder / "out", folder / "in/link");
  std::filesystem::create_symlink(folder / "in/loop", folder / "in/loop");
  std::filesystem::create_symlink("../gone", folder / "in/dead");
  ConfinedFiles files;
  CHECK(files.read(folder / "in/a", 99).status == ReadStatus::denied);
  files.allow(folder / "in");
  CHECK(files.read(folder / "in/a", 99).text == "in/a");
  CHECK(files.read(folder / "in/../in/a", 99).text == "in/a");
  CHECK(files.read(folder / "in/gone", 99).status == ReadStatus::not_found);
  for (const char* name : {"out", "inside", "in/../out", "in/link"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).status == ReadStatus::denied);
    CHECK(!files.is_file(folder / name));
    CHECK(files.is_denied(folder / name));
  }
  for (const char* name : {"gone", "in/../gone", "in/dead", "in/link/inner"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).reason == files.read(folder / "out", 99).reason);
    CHECK(files.is_denied(folder / name));
  }
  CHECK(files.read(folder / "in/loop", 99).status != ReadStatus::ok);
  CHECK(files.list(folder / "in") == Names{"a", "dead", "link", "loop"});
  CHECK(files.list(folder / ".").empty());
  files.allow("/");
  CHECK(files.read(folder / "out", 99).text == "out");
}

TEST_CASE("files: confined to the visible files in a folder, and to those of a name") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "home/work/deep");
  std::filesystem::create_directories(folder / "home/.ssh/deep");
  for (const char* name :
       {"home/a", "home/.b", "home/work/a", "home/work/.c", "home/.ssh/deep/rules", "rules"}) {
    std::ofstream(folder / name) << name;
  }
  ConfinedFiles files;
  files.allow_files_in(folder / "home");
  CHECK(files.read(folder / "home/a", 99).text == "home/a");
  CHECK(files.list(folder / "home") == Names{"a", "work"});
  CHECK(files.read(folder / "home/work/a", 99).text == "home/work/a");
  CHECK(files.list(folder / "home/work") == Names{"a", "deep"});
  for (const char* name : {"home/.b", "home/work/.c", "home/.ssh/deep/rules", "rules"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).status == ReadStatus::denied);
  }
  CHECK(files.list(folder / "home/.ssh").empty());
  files.allow_named("rules", folder / "home");
  CHECK(files.read(folder / "home/.ssh/deep/rules", 99).status == ReadStatus::ok);
  CHECK(files.read(folder / "rules", 99).status == ReadStatus::denied);
}

TEST_CASE("files: confined to folders without what has a name") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in/deep/.git/info");
  std::filesystem::create_directories(folder / "in/.hg");
  for (const char* name : {"in/a", "in/deep/.git/config", "in/deep/.git/info/exclude",
                           "in/.hg/hgrc", "in/deep/.gitignore"}) {
    std::ofstream(folder / name) << name;
  }
  std::filesystem::create_symlink("deep/.git/config", folder / "in/link");
  std::filesystem::create_symlink("deep/.git", folder / "in/way");
  ConfinedFiles files;
  files.deny_named(".git", "info/exclude");
  files.deny_named(".hg");
  files.allow(folder / "in");
  for (const char* name : {"in/a", "in/deep/.gitignore", "in/deep/.git/info/exclude"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).text == name);
  }
  for (const char* name : {"in/deep/.git/config", "in/deep/.git/gone", "in/link", "in/way/config",
                           "in/way/gone", "in/.hg/hgrc", "in/.hg", "in/deep/.git/info",
                           "in/deep/.git/info/exclude/x", "in/deep/.git"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).reason == files.read(folder / "out", 99).reason);
    CHECK(files.is_denied(folder / name));
    CHECK(!files.is_file(folder / name));
    CHECK(files.list(folder / name).empty());
  }
  // A work tree may be in there if the user names it.
  files.allow(folder / "in/.hg");
  CHECK(files.read(folder / "in/.hg/hgrc", 99).text == "in/.hg/hgrc");
}

TEST_CASE("files: links that go outside and come back tell nothing") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in/deep");
  std::filesystem::create_directories(folder / "other");
  std::ofstream(folder / "in/o") << "text";
  const auto link = [&](const std::string& name, const std::string& target) {
    std::filesystem::create_symlink(target, folder / name);
  };
  link("system", folder / "in");
  link("in/there", "../other/../in/o");
  link("in/gone", "../gone/../in/o");
  link("in/proc", "/proc/self/cwd/../" + (folder / "in/o"));
  link("in/deep/top", "../..");
  link("in/deep/there", "top/other/../in/o");
  link("in/deep/gone", "top/gone/../in/o");
  link("in/deep/by-there", "../there");
  link("in/way", "../other");
  link("in/way-back", "way/../in/o");
  link("in/deep/list", "../../other/../in");
  link("in/up", "../in/o");
  link("in/whole", folder / "in/o");
  link("in/by-system", folder / "system/o");
  link("in/deep/round", "top/in/deep/../o");
  ConfinedFiles files;
  files.allow(folder / "in");
  for (const char* name : {"in/there", "in/gone", "in/proc", "in/deep/there", "in/deep/gone",
                           "in/deep/by-there", "in/way-back", "in/way/x"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).reason == files.read(folder / "out", 99).reason);
    CHECK(files.is_denied(folder / name));
    CHECK(!files.is_file(folder / name));
  }
  for (const char* name :
       {"in/o", "in/up", "in/whole", "in/by-system", "in/deep/round", "system/o"}) {
    CAPTURE(name);
    CHECK(files.read(folder / name, 99).text == "text");
    CHECK(files.is_file(folder / name));
  }
  CHECK(files.list(folder / "in/deep/list").empty());
  CHECK(!files.list(folder / "system").empty());
  files.allow(folder / "other");
  CHECK(!files.list(folder / "in/deep/list").empty());
  CHECK(files.read(folder / "in/there", 99).text == "text");
  CHECK(files.is_denied(folder / "in/gone"));
}

TEST_CASE("files: all names of a file have one identity") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "a") << "text";
  std::ofstream(folder / "b") << "text";
  std::filesystem::create_symlink(".", folder / "l");
  ConfinedFiles confined;
  confined.allow(folder / ".");
  const DiskFiles disk;
  for (const FileReader* files :
       {static_cast<const FileReader*>(&confined), static_cast<const FileReader*>(&disk)}) {
    CHECK(files->identity(folder / "a") == files->identity(folder / "l/l/a"));
    CHECK(files->identity(folder / "a") != files->identity(folder / "b"));
    CHECK(files->identity(folder / "x/../gone") == files->identity(folder / "gone"));
    CHECK(MemoryFiles(files).identity(folder / "l/a") == files->identity(folder / "a"));
  }
  CHECK(MemoryFiles().identity("x/../a") == "a");
}
