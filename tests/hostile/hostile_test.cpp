// SPDX-License-Identifier: BSD-3-Clause
// Hostile input: the library reports it in bounded time, and does nothing
// else.
#include <doctest/doctest.h>

#include <ctime>
#include <functional>

#include "base/sanitizer.hpp"
#include "support/exercise.hpp"
#include "support/repeat.hpp"
#include "unit/random.hpp"

using namespace smurf;
using smurf::test::repeat;

namespace {

constexpr double kSeconds = SMURF_HAS_ADDRESS_SANITIZER ? 20 : 2;

const std::string kArm = SMURF_FIXTURES "/models/arm/";
constexpr const char* kUrdf = "<robot name='r'><link name='a'/></robot>";

std::string read_fixture(const std::string& path) {
  const FileContent content = DiskFiles().read(path, 1U << 20U);
  REQUIRE(content.status == ReadStatus::ok);
  return content.text;
}

/// The number of findings.
std::size_t check(const FileReader& files, const std::string& path, bool renders) {
  const test::Exercise result = test::exercise(files, path, {.renders = renders});
  for (const std::string& promise : result.broken) FAIL_CHECK(promise);
  return result.findings;
}

/// Processor time, which does not include other work of the machine.
double seconds(const std::function<void()>& run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A text in a file of its kind, alone or as a part of a model.
std::size_t check_text(const std::string& name, const std::string& text, bool renders = true) {
  MemoryFiles files;
  files.add(name, text);
  files.add("r.urdf", name == "r.urdf" ? text : kUrdf);
  files.add("r.smurf", name == "r.smurf" ? text : "files: [r.urdf, " + name + "]\n");
  const bool is_part = name.ends_with(".yml");
  return check(files, is_part ? "r.smurf" : name, renders);
}

const std::vector<std::string>& arm_files() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"urdf/arm.urdf"};
    for (const std::string& name : DiskFiles().list(kArm + "smurf")) all.push_back("smurf/" + name);
    return all;
  }();
  return names;
}

}  // namespace

TEST_CASE("hostile: every file of a model cut short at every byte") {
  const DiskFiles disk;
  for (const std::string& name : arm_files()) {
    CAPTURE(name);
    const std::string whole = read_fixture(kArm + name);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      MemoryFiles files;
      files.add(name, whole.substr(0, size));
      check(files, name, size % 64 == 0);
    }
    // Sometimes as a part of the whole model.
    for (std::size_t size = 0; size < whole.size(); size += 97) {
      MemoryFiles files(&disk);
      files.add(kArm + name, whole.substr(0, size));
      check(files, kArm + "smurf/arm.smurf", false);
    }
  }
}

TEST_CASE("hostile: bytes changed at random") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  for (const std::string& name : arm_files()) {
    CAPTURE(name);
    const std::string whole = read_fixture(kArm + name);
    for (int round = 0; round < 200; ++round) {
      std::string text = whole;
      for (std::size_t changes = 1 + random.below(8); changes > 0; --changes) {
        const std::size_t at = random.below(text.size());
        static constexpr std::string_view kLiked = "\"'<>&[]{}:,-#|\n\t \\*!%/=";
        switch (random.below(4)) {
        case 0: text[at] = static_cast<char>(random.below(256)); break;
        case 1: text[at] = kLiked[random.below(kLiked.size())]; break;
        case 2: text.erase(at, 1 + random.below(20)); break;
        default: text.insert(at, whole, random.below(whole.size()), random.below(40)); break;
        }
        if (text.empty()) text = " ";
      }
      MemoryFiles files;
      files.add(name, text);
      check(files, name, round % 16 == 0);
    }
  }
}

TEST_CASE("hostile: texts that are no model") {
  const std::string texts[] = {
      "",
      "\n",
      std::string(1, '\0'),
      std::string(100000, '\0'),
      "\xEF\xBB\xBF",
      "\xFF\xFE\x00\x00",
      "\x7F"
      "ELF\x02\x01\x01",
      "\x89PNG\r\n\x1A\n",
      "PK\x03\x04",
      "~",
      "[]",
      "{}",
      "- - - -",
      "? ? ?",
      "&a *a",
      "&a [*a, *a]",
      "*a",
      "!!",
      "!<",
      "|",
      ">",
      "%",
      "---",
      "...",
      "--- --- ---",
      "'",
      "\"",
      "\"\\",
      "<",
      "</",
      "<!",
      "<?",
      "<!--",
      "<![CDATA[",
      "<!DOCTYPE",
      "<!DOCTYPE a [",
      "<!DOCTYPE a [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><robot name='&a;'/>",
      "<a b",
      "<a b=",
      "<a b='",
      "<robot",
      "<robot/>",
      "<robot>\r\r\r</robot>",
      "files: [r.smurf]",
      "files: [., .., /, '', ~]",
      "files: [[[[]]]]",
      "files: {files: files}",
  };
  for (const std::string& text : texts) {
    CAPTURE(text);
    for (const char* name : {"r.smurf", "r.urdf", "a.yml", "s.smurfs"}) check_text(name, text);
  }
}

TEST_CASE("hostile: sections, entries and values that hold nothing") {
  constexpr std::string_view kSections[] = {
#define SMURF_SECTION(name) #name,
#include "ast/sections.def"
#undef SMURF_SECTION
      "entities", "physics", "environment", "scene", "files"};
  for (const std::string_view section : kSections) {
    for (const std::string_view value :
         {"{}", "[]", "[{}]", "[[]]", "[{}, {}]", "[null]", "[{name: a}]", "[{name: {}}]",
          "[{name: a, type: {}}]", "{a: {}}", "{a: []}", "''"}) {
      const std::string text = std::string(section) + ": " + std::string(value) + "\n";
      CAPTURE(text);
      for (const char* name : {"r.smurf", "s.smurfs", "a.yml"}) check_text(name, text);
    }
  }
}

TEST_CASE("hostile: sizes") {
  struct Case {
    std::string what;
    std::string name;
    std::string text;
  };
  constexpr std::size_t kMany = 100000;
  std::string attributes;
  for (int i = 0; i < 20000; ++i) attributes += " a" + std::to_string(i) + "='1'";
  std::string prefixes;
  for (std::size_t i = 0; i < kMany / 4; ++i) prefixes += "<p" + std::to_string(i) + ":a/>";
  std::string elements;
  for (std::size_t i = 0; i < kMany / 4; ++i) elements += "<e" + std::to_string(i) + "/>";
  std::string keys;
  for (std::size_t i = 0; i < kMany / 4; ++i) keys += "key" + std::to_string(i) + ": 1\n";
  std::string links;
  std::string joints;
  std::string motors = "motors:\n";
  for (int i = 0; i < 4000; ++i) {
    const std::string number = std::to_string(i);
    links += "<link name='link_number_" + number + "'/>";
    joints += "<joint name='j" + number + "' type='fixed'><parent link='link_numbr_" + number +
              "'/><child link='lnk_number_" + number + "'/></joint>";
    motors += "- {name: m" + number + ", joint: 'joint-number-" + number + "', type: PID}\n";
  }
  std::string bomb = "a0: &a0 [x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i <= 9; ++i) {
    const std::string below = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + repeat(below + ",", 9) +
            "]\n";
  }
  const auto robot = [](const std::string& inside) {
    return "<robot name='r'>" + inside + "</robot>";
  };
  const Case cases[] = {
      {"brackets", "a.yml", repeat("[", kMany)},
      {"brackets with commas", "a.yml", "a: " + repeat("[x,", kMany)},
      {"braces", "a.yml", repeat("{a: ", kMany)},
      {"closed brackets", "a.yml", repeat("[", kMany) + repeat("]", kMany)},
      {"a megabyte of brackets", "a.yml", repeat("[", 1U << 20U)},
      {"dashes", "a.yml", repeat("- ", kMany) + "x"},
      {"question marks", "a.yml", repeat("? ", kMany) + "x"},
      {"anchors", "a.yml", repeat("- &a x\n", kMany) + "- *a\n"},
      {"aliases", "a.yml", "a: &a x\nb:\n" + repeat("- *a\n", kMany)},
      {"alias bomb", "a.yml", bomb},
      {"a long line", "a.yml", "a: " + repeat("x ", 1U << 19U)},
      {"a long quoted line", "a.yml", "a: '" + repeat("x'' ", 1U << 18U) + "'"},
      {"a long key", "a.yml", repeat("k", 1U << 20U) + ": 1"},
      {"a long comment", "a.yml", "#" + repeat("#", 1U << 20U)},
      {"empty lines", "a.yml", repeat("\n", 1U << 20U) + "a: ["},
      {"one key again and again", "a.yml", repeat("a: 1\n", kMany / 4)},
      {"many keys", "a.yml", keys},
      {"many keys in a motor", "a.yml",
       "motors:\n- {name: m,\n" + repeat("    x: 1,\n", kMany / 4) + "}"},
      {"documents", "a.yml", repeat("---\na: 1\n", kMany)},
      {"broken motors", "a.yml", motors},
      {"wrong types", "a.yml",
       "motors:\n" + repeat("- {name: [1], joint: {a: b}, type: ~, p: x}\n", 4000)},
      {"no mappings", "a.yml", "motors:\n" + repeat("- 1\n", 20000)},
      {"nested elements", "r.urdf", repeat("<a>", kMany)},
      {"nested links", "r.urdf", robot(repeat("<link>", kMany))},
      {"attributes", "r.urdf", "<robot" + attributes + "/>"},
      {"prefixes", "r.urdf", robot(prefixes)},
      {"unknown elements", "r.urdf", robot("<link name='a'>" + elements + "</link>")},
      {"ampersands", "r.urdf", robot(repeat("&", kMany / 4))},
      {"a long attribute", "r.urdf", robot("<link name='" + repeat("x", 1U << 20U) + "'/>")},
      {"a long number", "r.urdf",
       robot("<joint name='j' type='fixed'><origin xyz='" + repeat("1 ", 1U << 19U) +
             "'/></joint>")},
      {"a long line of links", "r.urdf", robot(repeat("<link name='a'/>", 4000))},
      {"broken joints", "r.urdf", robot(links + joints)},
      {"comments", "r.urdf", robot(repeat("<!-- -- -->", kMany / 10))},
      {"text", "r.urdf", robot(repeat("text ", 1U << 18U))},
      {"files", "r.smurf", "files:\n" + repeat("- gone.yml\n", 4000)},
  };
  for (const Case& one : cases) {
    CAPTURE(one.what);
    std::size_t findings = 0;
    const double time = seconds([&] { findings = check_text(one.name, one.text); });
    CAPTURE(findings);
    if (std::getenv("SMURF_TEST_VERBOSE") != nullptr)
      MESSAGE(one.what << ": " << time << " s, " << findings);
    CHECK(time < kSeconds);
  }
}

TEST_CASE("hostile: paths") {
  const DiskFiles files;
  for (const char* path :
       {"", "/", ".", "/dev/zero", "/dev/null", "/proc/self/mem", "/nonexistent/x.smurf"}) {
    CAPTURE(path);
    CHECK(check(files, path, true) > 0);
  }
  CHECK(check(files, std::string("a\0b.smurf", 9), true) > 0);
  CHECK(check(files, std::string(100000, 'x') + ".smurf", true) > 0);
}
