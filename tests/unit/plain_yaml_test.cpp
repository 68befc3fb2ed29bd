// SPDX-License-Identifier: BSD-3-Clause
// Compares the scanner of plain YAML with yaml-cpp: both read a text that the scanner accepts to
// the same tree, byte for byte, with the same diagnostics. SMURF_TEST_CASES sets how many mutated
// texts are compared.
#include <doctest/doctest.h>

#include <iterator>

#include "support/described_yaml.hpp"
#include "support/texts.hpp"
#include "syntax/plain_yaml.hpp"

using namespace smurf;
using smurf::test::described_yaml;
using smurf::test::Random;

namespace {

bool is_plain(const std::string& text) {
  SourceMap sources;
  DiagnosticSink sink;
  const SourceId id = sources.add("a.yml", text);
  const Limits limits{.yaml_depth = text.size()};  // no limit that the text could reach
  YamlBuilder builder(sources, id, limits, sink);
  return !scan_plain_yaml(text, builder);
}

/// True when the scanner accepted the text.
bool compare(const std::string& text) {
  if (!is_plain(text)) return false;
  const std::string by_scanner = described_yaml(YamlEngine::scanner_first, text);
  const std::string by_yaml_cpp = described_yaml(YamlEngine::yaml_cpp, text);
  INFO(text);
  CHECK(by_scanner == by_yaml_cpp);
  return true;
}

constexpr std::string_view kExtensions[] = {".yml", ".yaml", ".smurf", ".smurfs", ".smurfa"};

std::string random_token(Random& random) {
  static constexpr std::string_view kTokens[] = {"a",
                                                 "b: ",
                                                 "c:",
                                                 "key: v",
                                                 "- ",
                                                 "-",
                                                 "  ",
                                                 " ",
                                                 "\n",
                                                 "\n  ",
                                                 "\n- ",
                                                 "\n    ",
                                                 "[",
                                                 "]",
                                                 "{",
                                                 "}",
                                                 ", ",
                                                 ",",
                                                 ": ",
                                                 ":",
                                                 "#",
                                                 " # c",
                                                 "'x'",
                                                 "\"y z\"",
                                                 "'",
                                                 "\"",
                                                 "''",
                                                 "~",
                                                 "null",
                                                 "1.5",
                                                 "-1",
                                                 ".5",
                                                 "---\n",
                                                 "...",
                                                 "? ",
                                                 "&a ",
                                                 "*a",
                                                 "!t ",
                                                 "|",
                                                 "x y",
                                                 "\t",
                                                 "\xC3\xA4",
                                                 "\\n",
                                                 "<<: ",
                                                 "a#b",
                                                 "a:b",
                                                 "%",
                                                 "@",
                                                 "\r\n",
                                                 "=",
                                                 "-a",
                                                 "a: [1, 2]\n",
                                                 "b: {c: d, e: [1]}\n",
                                                 "k:\n- 1\n- 2\n",
                                                 "k:\n  l: m\n",
                                                 "- n: 1\n  o: 2\n",
                                                 "'p q': r\n",
                                                 "- - s\n",
                                                 "\n\n",
                                                 "# t\n"};
  return std::string(kTokens[random.below(std::size(kTokens))]);
}

}  // namespace

TEST_CASE("the scanner takes what people write, and gives up at everything else") {
  for (const char* text :
       {"a: 1\n", "a:\n- 1\n- b: 2\n  c: 3\nd: {e: [1, -2.5], f: 'it''s'}\n", "a:\nb: ~\n",
        "# comment\na: \"x: y\" # more\n\nb:\n  - - 1\n    - 2\n  -\n", "a: [1,\n  2, # two\n 3]\n",
        "a: package://b/c#d\n", "- 1", "  a: b\n  c: d", "a:\nnull hypothesis: 1\n",
        "a: !t 1\nb: !degrees  -90.5 # c\nd: [!t 1, !t 'e']\ng: {h: !t i}\n", "- !t a\n- !t 'b'\n",
        "{\n  \"a\": [\n    1,\n    b\n  ]\n}\n# end\n"}) {
    CAPTURE(text);
    CHECK(compare(text));
  }
  for (const char* text : {"",
                           "a",
                           "a: b\n  c",
                           "a: &x 1",
                           "a: *x",
                           "a: !t null",
                           "a: !t",
                           "a: !t [1]",
                           "a: !t # b",
                           "a: !t\n  b",
                           "a: !!t b",
                           "a: !t !t b",
                           "a: !t &x b",
                           "a: !t b\n  c",
                           "- !t a: b",
                           "!t a: b",
                           "[!t a: b]",
                           "a: |\n  b",
                           "? a",
                           "a:\tb",
                           "a: b\r\n",
                           "---\na: 1",
                           "a: 1\n...\n",
                           "a: b: c",
                           "a: 'b\n  c'",
                           "a: \"\\n\"",
                           "[a: 1]",
                           "a: [1,,2]",
                           "a: [1, 2,]",
                           "{a: , b: 1}",
                           "a: [1, 2",
                           "a : b",
                           "- a\nb: 1",
                           "a: 1\n b: 2",
                           "~: 1",
                           "\xef\xbb\xbf"
                           "a: 1",
                           "a: 1#\x01",
                           "a: 'b",
                           "a: [b]c",
                           "[a]\nb: c",
                           "[a]: b",
                           "a: {b:1}"}) {
    CAPTURE(text);
    CHECK_FALSE(is_plain(text));
  }
}

TEST_CASE("both read the YAML of the fixtures and of the corpus alike") {
  test::compare_files(kExtensions, compare, 0.8);
}

TEST_CASE("both read mutated texts alike") {
  test::compare_made(kExtensions, compare, 0.1, [](const std::string& seed, Random& random) {
    if (random.one_in(2)) {
      return test::mutated(test::some_lines(seed, random), random_token, random);
    }
    std::string text;
    for (std::size_t tokens = 2 + random.below(14); tokens > 0; --tokens) {
      text += random_token(random);
    }
    return text;
  });
}
