// SPDX-License-Identifier: BSD-3-Clause
// Every YAML construct, with the bytes of its key and value.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/parsed.hpp"

using namespace smurf;
using smurf::test::join;
using smurf::test::Lines;
using smurf::test::ParsedYaml;

namespace {

struct Case {
  std::string title;
  std::string text;
  Lines lines;
};

void check(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    CAPTURE(one.title);
    const ParsedYaml parsed(one.text);
    CHECK(join(parsed.briefs()) == "");
    REQUIRE(parsed.document);
    CHECK(join(parsed.lines()) == join(one.lines));
  }
}

}  // namespace

TEST_CASE("yaml: spans of scalars") {
  check({
      {"plain", "a: b c  # note\n", {": map [a: b c]", "/a: [a] -> plain [b c]"}},
      {"plain with punctuation",
       "a: -1.5e3\nb: x:y\nc: it's \"so\"\nd: http://x#y\n",
       {": map [a: -1.5e3\\nb: x:y\\nc: it's \"so\"\\nd: http://x#y]", "/a: [a] -> plain [-1.5e3]",
        "/b: [b] -> plain [x:y]", "/c: [c] -> plain [it's \"so\"]",
        "/d: [d] -> plain [http://x#y]"}},
      {"multi-line plain",
       "a: one\n   two\n\n   three\nb: 1\n",
       {": map [a: one\\n   two\\n\\n   three\\nb: 1]",
        "/a: [a] -> plain [one\\n   two\\n\\n   three] = one two\\nthree", "/b: [b] -> plain [1]"}},
      {"plain on the next line",
       "a:\n  b\nc: d\n",
       {": map [a:\\n  b\\nc: d]", "/a: [a] -> plain [b]", "/c: [c] -> plain [d]"}},
      {"single quotes",
       "a: 'it''s'\nb: ''\n",
       {": map [a: 'it''s'\\nb: '']", "/a: [a] -> single ['it''s'] = it's",
        "/b: [b] -> single [''] = "}},
      {"double quotes",
       "a: \"x\\\"\\n\\u00e9\"\nb: \"\"\nc: \"\\\\\"\n",
       {": map [a: \"x\\\"\\n\\u00e9\"\\nb: \"\"\\nc: \"\\\\\"]",
        "/a: [a] -> double [\"x\\\"\\n\\u00e9\"] = x\"\\n\xC3\xA9",
        "/b: [b] -> double [\"\"] = ", "/c: [c] -> double [\"\\\\\"] = \\"}},
      {"quoted text over lines",
       "a: \"x\n  y\"\nb: 'x\n\n  y'\n",
       {": map [a: \"x\\n  y\"\\nb: 'x\\n\\n  y']", "/a: [a] -> double [\"x\\n  y\"] = x y",
        "/b: [b] -> single ['x\\n\\n  y'] = x\\ny"}},
      {"literal",
       "a: |\n  one\n   two\n\n  three\nb: 1\n",
       {": map [a: |\\n  one\\n   two\\n\\n  three\\nb: 1]",
        "/a: [a] -> block [|\\n  one\\n   two\\n\\n  three] = one\\n two\\n\\nthree\\n",
        "/b: [b] -> plain [1]"}},
      {"folded and stripped",
       "a: >-\n  one\n  two\n\nb: 1\n",
       {": map [a: >-\\n  one\\n  two\\n\\nb: 1]",
        "/a: [a] -> block [>-\\n  one\\n  two] = one two", "/b: [b] -> plain [1]"}},
      {"literal with indentation indicator and kept line ends",
       "a: |1+\n   one\n two\n\nb: 1\n",
       {": map [a: |1+\\n   one\\n two\\n\\nb: 1]",
        "/a: [a] -> block [|1+\\n   one\\n two] =   one\\ntwo\\n\\n", "/b: [b] -> plain [1]"}},
      {"literal before a comment",
       "a: | # note\n  one # text\n# note\nb: 1\n",
       {": map [a: | # note\\n  one # text\\n# note\\nb: 1]",
        "/a: [a] -> block [| # note\\n  one # text] = one # text\\n", "/b: [b] -> plain [1]"}},
      {"empty literal",
       "a: |\nb: 1\n",
       {": map [a: |\\nb: 1]", "/a: [a] -> block [|] = ", "/b: [b] -> plain [1]"}},
      {"literal as the whole document", "|\n one\n two", {": block [|\\n one\\n two] = one\\ntwo"}},
      {"literal in a list",
       "- |\n  one\n- two\n",
       {": list [- |\\n  one\\n- two]", "/0: block [|\\n  one] = one\\n", "/1: plain [two]"}},
  });
}

TEST_CASE("yaml: spans of collections") {
  check({
      {"block mapping and list",
       "a:\n  b: 1\n  c:\n  - x\n  - y: 2\n    z: 3\nd: 4\n",
       {": map [a:\\n  b: 1\\n  c:\\n  - x\\n  - y: 2\\n    z: 3\\nd: 4]",
        "/a: [a] -> map [b: 1\\n  c:\\n  - x\\n  - y: 2\\n    z: 3]", "/a/b: [b] -> plain [1]",
        "/a/c: [c] -> list [- x\\n  - y: 2\\n    z: 3]", "/a/c/0: plain [x]",
        "/a/c/1: map [y: 2\\n    z: 3]", "/a/c/1/y: [y] -> plain [2]", "/a/c/1/z: [z] -> plain [3]",
        "/d: [d] -> plain [4]"}},
      {"flow",
       "a: {b: [1, 2], c: {}}\nd: []\n",
       {": map [a: {b: [1, 2], c: {}}\\nd: []]", "/a: [a] -> map [{b: [1, 2], c: {}}]",
        "/a/b: [b] -> list [[1, 2]]", "/a/b/0: plain [1]", "/a/b/1: plain [2]",
        "/a/c: [c] -> map [{}]", "/d: [d] -> list [[]]"}},
      {"flow over lines with comments and a last comma",
       "a: [ 1, # ]\n  'x]',\n  ] # end\n",
       {": map [a: [ 1, # ]\\n  'x]',\\n  ]]", "/a: [a] -> list [[ 1, # ]\\n  'x]',\\n  ]]",
        "/a/0: plain [1]", "/a/1: single ['x]'] = x]"}},
      {"pairs in a flow list",
       "[a: 1, b, c: {d: 2}]",
       {": list [[a: 1, b, c: {d: 2}]]", "/0: map [a: 1]", "/0/a: [a] -> plain [1]",
        "/1: plain [b]", "/2: map [c: {d: 2}]", "/2/c: [c] -> map [{d: 2}]",
        "/2/c/d: [d] -> plain [2]"}},
      {"list in a list",
       "- - 1\n  - 2\n-\n  - 3\n",
       {": list [- - 1\\n  - 2\\n-\\n  - 3]", "/0: list [- 1\\n  - 2]", "/0/0: plain [1]",
        "/0/1: plain [2]", "/1: list [- 3]", "/1/0: plain [3]"}},
      {"explicit keys",
       "? a\n: 1\n? b\n",
       {": map [? a\\n: 1\\n? b]", "/a: [a] -> plain [1]", "/b: [b] -> null []"}},
      {"quoted keys",
       "\"a b\": 1\n'it''s': 2\n",
       {": map [\"a b\": 1\\n'it''s': 2]", "/a b: [\"a b\"] -> plain [1]",
        "/it's: ['it''s'] -> plain [2]"}},
      {"JSON",
       "{\"a\":1,\"b\":[true,null,\"x\"]}\n",
       {": map [{\"a\":1,\"b\":[true,null,\"x\"]}]", "/a: [\"a\"] -> plain [1]",
        "/b: [\"b\"] -> list [[true,null,\"x\"]]", "/b/0: plain [true]", "/b/1: null [null]",
        "/b/2: double [\"x\"] = x"}},
      {"JSON over lines, tabs as blanks",
       "{\n\t\"a\": [\n\t\t1\n\t],\n\t\"b\": {}\n}",
       {": map [{\\n\\t\"a\": [\\n\\t\\t1\\n\\t],\\n\\t\"b\": {}\\n}]",
        "/a: [\"a\"] -> list [[\\n\\t\\t1\\n\\t]]", "/a/0: plain [1]", "/b: [\"b\"] -> map [{}]"}},
  });
}

TEST_CASE("yaml: nulls are written or absent") {
  check({
      {"by absence in a block mapping",
       "a:\nb: ~\nc: null # x\nd: NULL\ne:\n",
       {": map [a:\\nb: ~\\nc: null # x\\nd: NULL\\ne:]", "/a: [a] -> null []",
        "/b: [b] -> null [~]", "/c: [c] -> null [null]", "/d: [d] -> null [NULL]",
        "/e: [e] -> null []"}},
      {"by absence in a block list",
       "- a\n-\n- ~\n-\n",
       {": list [- a\\n-\\n- ~\\n-]", "/0: plain [a]", "/1: null []", "/2: null [~]",
        "/3: null []"}},
      {"in flow",
       "{a: , b, c: ~, d: [null, ~]}",
       {": map [{a: , b, c: ~, d: [null, ~]}]", "/a: [a] -> null []", "/b: [b] -> null []",
        "/c: [c] -> null [~]", "/d: [d] -> list [[null, ~]]", "/d/0: null [null]",
        "/d/1: null [~]"}},
      {"absent before a key that is called null",
       "a:\nnull: 1\n",
       {": map [a:\\nnull: 1]", "/a: [a] -> null []", "/null: [null] -> plain [1]"}},
      {"absent with a property",
       "a: &x\nb: [&y , !!null ]\nc: {d: &z }\n",
       {": map [a: &x\\nb: [&y , !!null ]\\nc: {d: &z }]", "/a: [a] -> null []",
        "/b: [b] -> list [[&y , !!null ]]", "/b/0: null []", "/b/1: plain []",
        "/c: [c] -> map [{d: &z }]", "/c/d: [d] -> null []"}},
      {"an anchor that touches the comma",
       "[&x, null]",
       {": list [[&x, null]]", "/0: null []", "/1: null [null]"}},
      {"the whole document", "~\n", {": null [~]"}},
      {"words that only begin like null",
       "[nullable, ~x, nulls]",
       {": list [[nullable, ~x, nulls]]", "/0: plain [nullable]", "/1: plain [~x]",
        "/2: plain [nulls]"}},
  });
}

TEST_CASE("yaml: anchors, tags and aliases") {
  check({
      {"properties are not part of the value",
       "a: &x !!str 1\nb: !t [1]\nc: &y\n  d: 2\ne: !<tag:x,2000:y> 'z'\n",
       {": map [a: &x !!str 1\\nb: !t [1]\\nc: &y\\n  d: 2\\ne: !<tag:x,2000:y> 'z']",
        "/a: [a] -> plain [1]", "/b: [b] -> list [[1]]", "/b/0: plain [1]", "/c: [c] -> map [d: 2]",
        "/c/d: [d] -> plain [2]", "/e: [e] -> single ['z'] = z"}},
      {"an alias stands where it is written",
       "a: &x [1]\nb: *x\nc: [*x, *x]\n",
       {": map [a: &x [1]\\nb: *x\\nc: [*x, *x]]", "/a: [a] -> list [[1]]", "/a/0: plain [1]",
        "/b: [b] -> alias [*x]", "/c: [c] -> list [[*x, *x]]", "/c/0: alias [*x]",
        "/c/1: alias [*x]"}},
      {"an alias of a scalar",
       "a: &x 'it''s'\nb: *x\n",
       {": map [a: &x 'it''s'\\nb: *x]", "/a: [a] -> single ['it''s'] = it's",
        "/b: [b] -> alias [*x] = it's"}},
      {"an anchored key, and an alias as key",
       "&k a: 1\nb: *k\nc: {*k : 2}\n",
       {": map [a: 1\\nb: *k\\nc: {*k : 2}]", "/a: [a] -> plain [1]", "/b: [b] -> alias [*k] = a",
        "/c: [c] -> map [{*k : 2}]", "/c/a: [*k] -> plain [2]"}},
      {"an anchor used again means the later value",
       "- &x 1\n- *x\n- &x 2\n- *x\n",
       {": list [- &x 1\\n- *x\\n- &x 2\\n- *x]", "/0: plain [1]", "/1: alias [*x] = 1",
        "/2: plain [2]", "/3: alias [*x] = 2"}},
      {"merge keys are ordinary keys",
       "a: &x {b: 1}\nc:\n  <<: *x\n",
       {": map [a: &x {b: 1}\\nc:\\n  <<: *x]", "/a: [a] -> map [{b: 1}]", "/a/b: [b] -> plain [1]",
        "/c: [c] -> map [<<: *x]", "/c/<<: [<<] -> alias [*x]"}},
  });
  const ParsedYaml parsed("a: &x {b: [1, 2]}\nc: *x\n");
  CHECK(parsed.root().find("c").find("b").size() == 2);
  CHECK(parsed.root().find("c").span().begin == 21);
}

TEST_CASE("yaml: bytes around the values") {
  check({
      {"CR LF",
       "a: one\r\n  two\r\nb: |\r\n  x\r\n  y\r\nc: 'q'\r\nd:\r\n",
       {": map [a: one\\r\\n  two\\r\\nb: |\\r\\n  x\\r\\n  y\\r\\nc: 'q'\\r\\nd:]",
        "/a: [a] -> plain [one\\r\\n  two] = one two",
        "/b: [b] -> block [|\\r\\n  x\\r\\n  y] = x\\ny\\n", "/c: [c] -> single ['q'] = q",
        "/d: [d] -> null []"}},
      {"byte order mark",
       "\xEF\xBB\xBF"
       "a: 1\nb: [x]\n",
       {": map [a: 1\\nb: [x]]", "/a: [a] -> plain [1]", "/b: [b] -> list [[x]]",
        "/b/0: plain [x]"}},
      {"Unicode",
       "gr\xC3\xB6\xC3\x9F"
       "e: \xE2\x82\xAC 5\n\xF0\x9F\xA4\x96: [\xE6\x97\xA5]\n",
       {": map [gr\xC3\xB6\xC3\x9F"
        "e: \xE2\x82\xAC 5\\n\xF0\x9F\xA4\x96: [\xE6\x97\xA5]]",
        "/gr\xC3\xB6\xC3\x9F"
        "e: [gr\xC3\xB6\xC3\x9F"
        "e] -> plain [\xE2\x82\xAC 5]",
        "/\xF0\x9F\xA4\x96: [\xF0\x9F\xA4\x96] -> list [[\xE6\x97\xA5]]",
        "/\xF0\x9F\xA4\x96/0: plain [\xE6\x97\xA5]"}},
      {"comments everywhere",
       "# top\na: # key\n  # value\n  b # end\n# tail\n",
       {": map [a: # key\\n  # value\\n  b]", "/a: [a] -> plain [b]"}},
      {"directives and document marks",
       "%YAML 1.2\n---\na: 1\n...\n",
       {": map [a: 1]", "/a: [a] -> plain [1]"}},
      {"no line end at the end", "a: b", {": map [a: b]", "/a: [a] -> plain [b]"}},
      {"nothing", "", {}},
      {"only a comment", "# nothing\n", {}},
  });
}

TEST_CASE("yaml: pointers and places") {
  const std::string text = "motors:\n- name: a\n  'x/y~z': [1, 2]\n- name:\n";
  const ParsedYaml parsed(text);
  REQUIRE(parsed.document);
  const yaml::View motors = parsed.root().find("motors");
  const yaml::View first = *motors.begin();
  CHECK(yaml::pointer(*parsed.document, parsed.root().id()).empty());
  CHECK(yaml::pointer(*parsed.document, first.find("x/y~z").id()) == "/motors/0/x~1y~0z");

  struct Place {
    std::string what;
    std::string pointer;
  };
  const Place places[] = {{"motors", "/motors"},         {"name: a", "/motors/0/name"},
                          {"a\n", "/motors/0/name"},     {"'x/y", "/motors/0/x~1y~0z"},
                          {"1,", "/motors/0/x~1y~0z/0"}, {", 2", "/motors/0/x~1y~0z"},
                          {"2]", "/motors/0/x~1y~0z/1"}, {"name:\n", "/motors/1/name"}};
  for (const Place& place : places) {
    CAPTURE(place.what);
    const auto offset = static_cast<std::uint32_t>(text.find(place.what));
    CHECK(yaml::pointer(*parsed.document, yaml::node_at(*parsed.document, offset)) ==
          place.pointer);
  }
  CHECK(parsed.root().find("motors").place() == parsed.root().find("motors").span());
  const yaml::View absent = (*++motors.begin()).find("name");
  CHECK(absent.place() == absent.key_span());
}

TEST_CASE("yaml: node_at outside of everything") {
  const ParsedYaml empty("# nothing\n");
  CHECK(yaml::node_at(*empty.document, 3) == yaml::kNoNode);
  const ParsedYaml parsed("# top\na: 1\n");
  CHECK(yaml::node_at(*parsed.document, 0) == yaml::kNoNode);
}

TEST_CASE("yaml: scalars mean what the YAML 1.2 core schema says") {
  using enum yaml::ScalarType;
  struct Row {
    std::string text;
    yaml::ScalarType type;
  };
  const Row rows[] = {{"", null},         {"~", null},        {"null", null},
                      {"Null", null},     {"NULL", null},     {"nULL", text},
                      {"true", boolean},  {"True", boolean},  {"TRUE", boolean},
                      {"tRUE", text},     {"false", boolean}, {"yes", text},
                      {"on", text},       {"n", text},        {"0", integer},
                      {"-0", integer},    {"+12", integer},   {"012", integer},
                      {"0o14", integer},  {"0x1F", integer},  {"0xg", text},
                      {"0o8", text},      {"0x", text},       {"0x-1", text},
                      {"0b11", text},     {"1_000", text},    {"1,5", text},
                      {"--1", text},      {"+-1", text},      {"-", text},
                      {"+", text},        {".", text},        {"1.", number},
                      {".5", number},     {"-.5", number},    {"+1.5e-3", number},
                      {"1e3", number},    {"1E+3", number},   {"1e", text},
                      {"e3", text},       {"1e3.5", text},    {".inf", number},
                      {"-.inf", number},  {"+.INF", number},  {".Inf", number},
                      {"inf", text},      {".iNF", text},     {".nan", number},
                      {".NaN", number},   {"-.nan", text},    {"nan", text},
                      {"12:30:45", text}, {"45deg", text},    {"1 2", text},
                      {"0x1p3", text},    {"1e400", text},    {"99999999999999999999", number}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CHECK(yaml::classify(row.text, yaml::Style::plain) == row.type);
    CHECK(yaml::classify(row.text, yaml::Style::single_quoted) == text);
    CHECK(yaml::classify(row.text, yaml::Style::double_quoted) == text);
    CHECK(yaml::classify(row.text, yaml::Style::block) == text);
  }
}

TEST_CASE("yaml: values of scalars") {
  const ParsedYaml parsed("[1.5, 0x10, 0o17, -.inf, .nan, true, '1', abc, ~, [1], +7, 1e-400]");
  const auto at = [&](std::size_t i) {
    auto item = parsed.root().begin();
    while (i-- > 0) ++item;
    return *item;
  };
  CHECK(at(0).number() == 1.5);
  CHECK(!at(0).integer());
  CHECK(at(1).number() == 16.0);
  CHECK(at(1).integer() == 16);
  CHECK(at(2).integer() == 15);
  CHECK(at(3).number() == -HUGE_VAL);
  CHECK(std::isnan(at(4).number().value()));
  CHECK(at(5).boolean() == true);
  CHECK(!at(5).number());
  CHECK(!at(6).number());
  CHECK(!at(6).integer());
  CHECK(!at(7).number());
  CHECK(!at(7).boolean());
  CHECK(!at(8).number());
  CHECK(!at(9).number());
  CHECK(!at(9).boolean());
  CHECK(at(10).integer() == 7);
  CHECK(at(10).number() == 7.0);
  CHECK(!at(11).number());
  CHECK(!at(0).find("x"));
  CHECK(!yaml::View().find("x"));
}
