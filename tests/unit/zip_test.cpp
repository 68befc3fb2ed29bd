// SPDX-License-Identifier: BSD-3-Clause
// Archives that are sound, too large, broken, or reach outside of themselves.
#include "archive/zip.hpp"

#include <doctest/doctest.h>
#include <random>

#include "smurf/archive_files.hpp"
#include "support/zip_writer.hpp"

using namespace smurf;
using smurf::test::zip;

namespace {

Limits at_most(std::uint64_t bytes) {
  Limits limits;
  limits.archive_bytes = bytes;
  return limits;
}

}  // namespace

TEST_CASE("files of an archive are sorted by name") {
  const Archive archive =
      read_zip(zip({{"b/c.txt", "two"}, {"d/", ""}, {"a.txt", "one"}}), at_most(100));
  CHECK(archive.reason == "");
  REQUIRE(archive.files.size() == 2);
  CHECK(archive.files[0].path == "a.txt");
  CHECK(archive.files[0].text == "one");
  CHECK(archive.files[1].path == "b/c.txt");
  CHECK(archive.files[1].text == "two");
}

TEST_CASE("the limit is that of all files together") {
  const std::string bytes = zip({{"a", "12345"}, {"b", "67890"}});
  CHECK(read_zip(bytes, at_most(10)).files.size() == 2);
  const Archive archive = read_zip(bytes, at_most(9));
  CHECK(archive.reason.starts_with("unpacks to more than 9 bytes"));
  CHECK(archive.files.empty());
}

TEST_CASE("the limit is that of all archives together") {
  ArchiveBudget budget(at_most(10));
  CHECK(read_zip(zip({{"a", "12345"}}), budget).reason == "");
  CHECK(read_zip(zip({{"a", "12345"}}), budget).reason == "");
  CHECK(read_zip(zip({{"a", "1"}}), budget).reason.find("to more than 10 bytes") !=
        std::string::npos);
}

TEST_CASE("files do not share their bytes") {
  std::string noise;
  std::mt19937 dice(1);
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>(dice());
  const std::string one = zip({{"a", noise}});
  CHECK(read_zip(one, at_most(100'000)).reason == "");
  // The directory lists the file twice; its trailer contains the number of files and the bytes of
  // the directory.
  const std::size_t list = one.find("PK\x01\x02");
  const std::size_t trailer = one.find("PK\x05\x06");
  const std::string entry = one.substr(list, trailer - list);
  std::string twice = one.substr(0, trailer) + entry + one.substr(trailer);
  const std::size_t moved = trailer + entry.size();
  twice[moved + 8] = twice[moved + 10] = 2;
  twice[moved + 12] = static_cast<char>(2 * entry.size());
  CHECK(read_zip(twice, at_most(100'000)).reason == "contains files that share their bytes");
}

/// A file whose checksum and sizes stand behind its bytes, after `before`.
std::string zip_with_sizes_behind(const std::string& text, const std::string& before,
                                  const std::string& after = "") {
  std::string bytes = zip({{"a.txt", text}});
  const std::size_t directory = bytes.find("PK\x01\x02");
  for (const std::size_t header : {std::size_t{0}, directory + 2}) bytes[header + 6] = 8;  // a flag
  const std::string behind = before + bytes.substr(14, 12) + after;
  const std::size_t trailer = bytes.find("PK\x05\x06");
  bytes[trailer + 16] = static_cast<char>(directory + behind.size());
  return bytes.insert(directory, behind);
}

TEST_CASE("sizes may be behind a file") {
  const auto reason = [](const std::string& before, const std::string& after = "") {
    return read_zip(zip_with_sizes_behind("some text", before, after), at_most(100)).reason;
  };
  CHECK(reason("") == "");
  CHECK(reason("PK\x07\x08") == "");
  CHECK(reason("xxxx") == "is a broken zip archive");
  CHECK(reason("", "x") == "is a broken zip archive");
  CHECK(reason("", std::string(28, 'x')) == "is a broken zip archive");
}

TEST_CASE("a file ends in one place") {
  const std::string sound = zip_with_sizes_behind("some text", "PK\x07\x08");
  for (const std::size_t behind : {4U, 8U, 12U}) {  // checksum and sizes
    std::string other = sound;
    other[other.find("PK\x07\x08") + behind] ^= 1;
    CHECK(read_zip(other, at_most(100)).reason == "is a broken zip archive");
  }
  for (const std::size_t in_header : {14U, 18U, 22U}) {  // neither 0 nor the sizes behind
    std::string other = sound;
    other[in_header] ^= 1;
    CHECK(read_zip(other, at_most(100)).reason ==
          "contains the file 'a.txt', whose header differs from the directory");
  }
  // A program that unpacks a stream ends the file at the first of two ends.
  const std::string first = zip_with_sizes_behind("some text", "PK\x07\x08");
  const std::string end = first.substr(first.find("PK\x07\x08"), 16);
  CHECK(read_zip(zip_with_sizes_behind("some text" + end + "more", "PK\x07\x08"), at_most(100))
            .reason == "contains the file 'a.txt', which may end in two places");
}

TEST_CASE("names stay inside") {
  for (const char* name : {"../a", "a/../../b", "/a", "a\\b", "a/."}) {
    CAPTURE(name);
    CHECK(read_zip(zip({{name, "x"}}), at_most(100)).reason.find("not inside") !=
          std::string::npos);
  }
}

TEST_CASE("no archive means one thing to one program and another to the next") {
  CHECK(read_zip(zip({{"a", "1"}, {"./a", "2"}}), at_most(100)).reason ==
        "contains two files named 'a'");
  const std::string sound = zip({{"a.txt", "some text"}, {"b.txt", "more text"}});
  REQUIRE(read_zip(sound, at_most(100)).reason == "");
  const std::size_t trailer = sound.find("PK\x05\x06");

  std::string uncounted = sound;
  uncounted[trailer + 8] = uncounted[trailer + 10] = 1;  // number of files
  CHECK(read_zip(uncounted, at_most(100)).reason == "is a broken zip archive");
  CHECK(read_zip(sound + "PK\x05\x06", at_most(100)).reason == "is a broken zip archive");
  CHECK(read_zip("another archive" + sound, at_most(100)).reason == "is a broken zip archive");

  // The last directory is that of the second archive, but the first files are those of the first
  // archive.
  const std::string other = zip({{"b.txt", "other text"}});
  std::string commented = sound.substr(0, sound.size() - 2);
  test::append(commented, static_cast<std::uint32_t>(other.size()), 2);
  CHECK(read_zip(commented + other, at_most(100)).reason == "is a broken zip archive");
  // A file before the directory without an entry in it.
  const std::size_t directory = sound.find("PK\x01\x02");
  const std::string packed = other.substr(0, other.find("PK\x01\x02"));
  std::string unnamed = sound.substr(0, directory) + packed + sound.substr(directory);
  REQUIRE(packed.size() < 100);
  unnamed[trailer + packed.size() + 16] = static_cast<char>(directory + packed.size());
  CHECK(read_zip(unnamed, at_most(100)).reason == "is a broken zip archive");
  // Newer programs read the directory that this record names.
  std::string large = sound.substr(0, trailer) + "PK\x06\x06";
  test::append_zeros(large, 52);
  CHECK(read_zip(large + sound.substr(trailer), at_most(100)).reason == "is a broken zip archive");

  // minizip does not compare the checksum of an entry that claims to be larger.
  std::string shorter = sound;
  const std::size_t entry = sound.find("PK\x01\x02");
  for (const std::size_t header : {sound.find("PK\x03\x04") - 2, entry}) {
    shorter[header + 16] = static_cast<char>(shorter[header + 16] + 1);  // checksum
    shorter[header + 24] = 100;                                          // unpacked size
  }
  CHECK(read_zip(shorter, at_most(1000)).reason == "is a broken zip archive");

  std::string other_name = sound;
  other_name[sound.find("b.txt")] = 'c';
  CHECK(read_zip(other_name, at_most(100)).reason ==
        "contains the file 'b.txt', whose header has another name");

  std::string packed_otherwise = sound;
  packed_otherwise[sound.find("PK\x03\x04") + 8] = packed_otherwise[entry + 10] = 93;
  CHECK(read_zip(packed_otherwise, at_most(100)).reason ==
        "contains the file 'a.txt', which is packed with a method other than deflate");
}

namespace {

/// An entry of an archive for tests, stored as it is.
struct Entry {
  std::string name, text;
  std::string extra = {};        ///< field of the directory
  std::string local_name = {};   ///< in the header, if it differs
  std::uint32_t attributes = 0;  ///< of the file, for Unix in the upper half
  std::uint32_t local_flags = 0, flags = 0;
};

std::string zip_of(const std::vector<Entry>& entries) {
  std::string bytes;
  std::string directory;
  for (const Entry& entry : entries) {
    const auto offset = static_cast<std::uint32_t>(bytes.size());
    const std::string& local = entry.local_name.empty() ? entry.name : entry.local_name;
    std::string header = "PK\3\4";
    test::append_facts(header, local, entry.text);
    header[6] = static_cast<char>(entry.local_flags);
    header[7] = static_cast<char>(entry.local_flags >> 8U);
    bytes += header + local + entry.text;
    std::string central = "PK\1\2";
    test::append(central, 0x0314, 2);
    test::append_facts(central, entry.name, entry.text);
    central[8] = static_cast<char>(entry.flags);
    central[9] = static_cast<char>(entry.flags >> 8U);
    central[30] = static_cast<char>(entry.extra.size());
    test::append_zeros(central, 6);  // comment, disk, inner attributes
    test::append(central, entry.attributes, 4);
    test::append(central, offset, 4);
    directory += central + entry.name + entry.extra;
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + "PK\5\6";
  test::append(bytes, 0, 4);
  for (int i = 0; i < 2; ++i) test::append(bytes, static_cast<std::uint32_t>(entries.size()), 2);
  test::append(bytes, static_cast<std::uint32_t>(directory.size()), 4);
  test::append(bytes, start, 4);
  test::append(bytes, 0, 2);
  return bytes;
}

/// The field in which Info-ZIP writes the name in Unicode.
std::string unicode_path(const std::string& name, const std::string& unicode) {
  std::string field;
  test::append(field, 0x7075, 2);
  test::append(field, static_cast<std::uint32_t>(5 + unicode.size()), 2);
  field += '\1';
  test::append(field, test::crc32(name), 4);
  return field + unicode;
}

/// With the flag that says that its name is in UTF-8.
Entry utf8_named(const std::string& name, const std::string& text) {
  return {name, text, {}, {}, 0, 1U << 11U, 1U << 11U};
}

std::string reason_of(const std::vector<Entry>& entries) {
  return read_zip(zip_of(entries), at_most(1000)).reason;
}

}  // namespace

TEST_CASE("names and kinds of entries mean the same to every program") {
  CHECK(reason_of({{"a/", ""}, {"a/b", "1", {}, {}, 0100644U << 16U}, {"c", "2"}}) == "");
  CHECK(reason_of({{"a", "1", unicode_path("a", "a")}}) == "");
  CHECK(reason_of({{"a", "1", unicode_path("a", "b")}}) ==
        "contains the file 'a', which has a second name");
  CHECK(reason_of({{"a", "1", "\x75\x70"}}) == "is a broken zip archive");

  CHECK(reason_of({{"./", "x", {}, "./r.urdf"}, {"r.urdf", "y"}}) ==
        "contains the file './', whose header has another name");
  CHECK(reason_of({{"d/", "x"}}) == "contains the folder 'd/', which has content");
  CHECK(reason_of({{"../d/", ""}}) == "contains the file '../d/', which is not inside it");
  CHECK(reason_of({{"C:/x.yml", "1"}}) == "contains the file 'C:/x.yml', which is not inside it");

  CHECK(reason_of({{"r.urdf", "target", {}, {}, 0120777U << 16U}}) ==
        "contains 'r.urdf', which is a link or no plain file");
  CHECK(reason_of({{"d", "", {}, {}, 0x10}}) == "contains 'd', which is a link or no plain file");
  CHECK(reason_of({{"a", "1", {}, {}, 0, 1, 0}}) ==
        "contains the file 'a', whose header differs from the directory");

  CHECK(reason_of({{"Arm.yml", "1"}, {"arm.yml", "2"}}) ==
        "contains the files 'Arm.yml' and 'arm.yml', which are one file on some systems");
  CHECK(reason_of({utf8_named("n\u00e9.yml", "1"), utf8_named("ne\u0301.yml", "2")})
            .find("one file on some systems") != std::string::npos);
  CHECK(reason_of({utf8_named("n\u00e9.yml", "1"), utf8_named("n\u00e8.yml", "2")}) == "");
  // Python reads it in the code page 437, others in that of the system.
  CHECK(
      reason_of({{"n\u00e9.yml", "1"}}) ==
      "contains the file 'n\u00e9.yml', whose name is not marked as UTF-8; give it a name of ASCII "
      "characters");
  CHECK(reason_of({utf8_named("n\xff.yml", "1")}).find("is not marked as UTF-8") !=
        std::string::npos);
  CHECK(reason_of({{"s.smurfs", "1"}, {"s.smurfs/x.yml", "2"}}) ==
        "contains the file 's.smurfs', which is also a folder");
  CHECK(reason_of({{"S.smurfs", "1"}, {"s.smurfs/x.yml", "2"}}) ==
        "contains the file 'S.smurfs', which is also a folder");
  for (const std::string name : {"r.urdf.", "r.urdf ", "r.urdf::$DATA", "a./r.urdf", "a /r.urdf"}) {
    CHECK(reason_of({{name, "1"}}) ==
          "contains the file '" + name + "', which has another name on Windows");
  }
  const std::pair<std::string, std::string> pairs[] = {
      {"k.urdf", "\u212a.urdf"},        {"s.urdf", "\u017f.urdf"},
      {"r.urdf", "\uff32.urdf"},        {"r.urdf", "r\u200b.urdf"},
      {"r\u200b.urdf", "r\u200c.urdf"}, {"\u00c4.urdf", "\u00e4.urdf"},
      {"\u0416.urdf", "\u0436.urdf"}};
  for (const auto& [one, other] : pairs) {
    CHECK(reason_of({utf8_named(one, "1"), utf8_named(other, "2")}) ==
          "contains the files '" + one + "' and '" + other +
              "', which are one file on some systems");
  }
  CHECK(reason_of({utf8_named("\u00e4.urdf", "1"), utf8_named("\u00f6.urdf", "2")}).empty());
}

TEST_CASE("no archive is hidden in another one") {
  // The comment of the outer archive is an archive with the same names and lengths.
  const std::string inner = zip({{"r.urdf", "evil"}});
  std::string outer = zip({{"r.urdf", "good"}});
  outer.resize(outer.size() - 2);
  test::append(outer, static_cast<std::uint32_t>(inner.size()), 2);
  CHECK(read_zip(outer + inner, at_most(1000)).reason ==
        "contains the file 'r.urdf', whose header differs from the directory");

  // Where sizes are behind the file, a reader of a stream looks for its end.
  const std::string hidden = inner.substr(0, inner.find("PK\x01\x02"));
  std::string bytes = zip_of({{"a.txt", "some" + hidden, {}, {}, 0, 8, 8}});
  const std::size_t directory = bytes.rfind("PK\x01\x02");
  const std::size_t trailer = bytes.rfind("PK\x05\x06");
  bytes[trailer + 16] = static_cast<char>(directory + 12);
  bytes.insert(directory, bytes.substr(14, 12));
  CHECK(read_zip(bytes, at_most(1000)).reason ==
        "contains the file 'a.txt', in which another archive begins");
}

TEST_CASE("broken archives are refused, whatever is broken") {
  CHECK(read_zip("", at_most(100)).reason == "is not a zip archive");
  CHECK(read_zip("PK", at_most(100)).reason == "is not a zip archive");
  const std::string sound = zip({{"a.txt", "some text"}, {"b.txt", "more text"}});
  // minizip reads missing bytes as zeros, and the last four bytes are zeros.
  for (std::size_t size = 0; size + 4 < sound.size(); ++size) {
    CAPTURE(size);
    CHECK(!read_zip(std::string_view(sound).substr(0, size), at_most(100)).reason.empty());
  }
  std::string wrong = sound;
  wrong[wrong.find("some")] = 'S';  // the checksum differs
  CHECK(read_zip(wrong, at_most(100)).reason == "is a broken zip archive");
  std::mt19937 dice(1);
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = sound;
    for (int i = 0; i < 3; ++i) bytes[dice() % bytes.size()] = static_cast<char>(dice());
    const Archive archive = read_zip(bytes, at_most(1000));
    CHECK((archive.reason.empty() || archive.files.empty()));
  }
}

TEST_CASE("archives as folders") {
  const std::string inner = zip({{"a/b.txt", "inner"}});
  MemoryFiles files;
  files.add("x/outer.ZSMURFS", zip({{"top.txt", "outer"}, {"in/deep.zsmurf", inner}}));
  files.add("broken.zsmurf", "PK no");
  files.add("folder.zsmurf/plain.txt", "a folder, whatever it is called");
  const ArchiveFiles archives(files, at_most(1000));
  const auto read = [&](const std::string& path) { return archives.read(path, 1000); };

  CHECK(read("x/outer.ZSMURFS/top.txt").text == "outer");
  CHECK(read("x/./outer.ZSMURFS/in/../in/deep.zsmurf/a/b.txt").text == "inner");
  CHECK(read("x/outer.ZSMURFS/in/deep.zsmurf").text == inner);
  CHECK(read("folder.zsmurf/plain.txt").text.starts_with("a folder"));
  CHECK(archives.is_file("x/outer.ZSMURFS"));
  CHECK(archives.is_file("x/outer.ZSMURFS/in/deep.zsmurf/a/b.txt"));
  CHECK(!archives.is_file("x/outer.ZSMURFS/in/deep.zsmurf/a"));
  CHECK(read("x/outer.ZSMURFS/none").status == ReadStatus::not_found);
  CHECK(archives.read("x/outer.ZSMURFS/top.txt", 2).status == ReadStatus::too_large);
  CHECK(archives.list("x/outer.ZSMURFS") == std::vector<std::string>{"in", "top.txt"});
  CHECK(archives.list("x/outer.ZSMURFS/in/deep.zsmurf/a") == std::vector<std::string>{"b.txt"});
  CHECK(read("broken.zsmurf/a.smurf").status == ReadStatus::denied);
  CHECK(read("broken.zsmurf/a.smurf").reason == "the archive is not a zip archive");
}

TEST_CASE("all archives together unpack to a limit") {
  MemoryFiles files;
  files.add("a.zsmurf", zip({{"a.smurf", std::string(60, 'a')}}));
  files.add("b.zsmurf", zip({{"b.smurf", std::string(60, 'b')}}));
  const ArchiveFiles archives(files, at_most(100));
  CHECK(archives.is_file("a.zsmurf/a.smurf"));
  CHECK(!archives.is_file("b.zsmurf/b.smurf"));
  CHECK(main_file_of_archive("a.zsmurf", archives).path == "a.zsmurf/a.smurf");
  CHECK(main_file_of_archive("b.zsmurf", archives).reason ==
        "unpacks, with the archives before it, to more than 100 bytes; raise the limit with "
        "`--limit archive-bytes=N`");
}
