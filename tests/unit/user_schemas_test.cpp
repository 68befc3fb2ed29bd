// SPDX-License-Identifier: BSD-3-Clause
// Schemas of a user's own sections and entity types, through the library's interface: violations,
// their places and messages; and schemas that are broken or hostile.
#include <algorithm>
#include <chrono>

#include <doctest/doctest.h>

#include "smurf/load.hpp"
#include "support/loaded.hpp"
#include "support/repeat.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// A model with the section `rainbow` and a schema for it.
struct Rainbow {
  SourceMap sources;
  DiagnosticSink sink;
  UserSchemas schemas;
  std::vector<Diagnostic> found;
  bool is_registered = false;

  Rainbow(const std::string& schema, const std::string& section) {
    const SourceId source = sources.add("rainbow.json", schema);
    is_registered = schemas.add_section("rainbow", source, sources, sink);
    MemoryFiles files;
    files.add("arm.smurf", "modelname: arm\nfiles: [arm.urdf, arm_rainbow.yml]\n");
    files.add("arm.urdf", "<robot name=\"arm\"><link name=\"base\"/></robot>\n");
    files.add("arm_rainbow.yml", "rainbow: " + section + "\n");
    LoadContext context{sources, files, sink, {}, {}};
    context.schemas = &schemas;
    const LinkedModel model = load_model("arm.smurf", context);
    lint_model(model, {}, sink);
    found = sink.take();
    locate(model, found);
    found = apply_selection(std::move(found), sources, {});
    // MARS accepts only lists and mappings, independently of a schema.
    std::erase_if(found, [](const Diagnostic& one) { return one.rule->id == "SML2008"; });
  }

  std::string messages() const {
    std::string all;
    for (const Diagnostic& diagnostic : found) all += diagnostic.message + "\n";
    return all;
  }
};

struct KeywordCase {
  std::string schema, section, message;
};

}  // namespace

TEST_CASE("every keyword has its words") {
  const std::vector<KeywordCase> cases = {
      {R"({"type": "object"})", "3", "`rainbow` must be a mapping, not `3`"},
      {R"({"type": ["integer", "null"]})", "3.5",
       "`rainbow` must be a whole number or nothing, not `3.5`"},
      {R"({"enum": ["red", "green"]})", "gren", "`rainbow` is not one of `red` or `green`"},
      {R"({"const": 7})", "8", "`rainbow` must be `7`"},
      {R"({"maximum": 0.5})", "1", "`rainbow` must be at most `0.5`"},
      {R"({"exclusiveMaximum": 1})", "1", "`rainbow` must be less than `1`"},
      {R"({"minimum": 2})", "1", "`rainbow` must be at least `2`"},
      {R"({"exclusiveMinimum": 1})", "1", "`rainbow` must be greater than `1`"},
      {R"({"multipleOf": 3})", "4", "`rainbow` must be a multiple of `3`"},
      {R"({"multipleOf": 0.25})", "0.3", "`rainbow` must be a multiple of `0.25`"},
      {R"({"maxItems": 1})", "[1, 2]", "`rainbow` contains at most `1` items"},
      {R"({"minItems": 3})", "[1, 2]", "`rainbow` contains at least `3` items"},
      {R"({"uniqueItems": true})", "[1, 2, 1]", "`rainbow` contains an item twice"},
      {R"({"contains": {"const": 3}})", "[1, 2]",
       "`rainbow` lacks an item that the schema requires"},
      {R"({"items": [{"type": "number"}], "additionalItems": false})", "[1, 2]",
       "`rainbow` contains too many items"},
      {R"({"maxLength": 2})", "red", "`rainbow` has at most `2` characters"},
      {R"({"minLength": 4})", "red", "`rainbow` has at least `4` characters"},
      {R"({"pattern": "^b"})", "red", "`rainbow` does not match the pattern `^b`"},
      {R"({"maxProperties": 1})", "{a: 1, b: 2}", "`rainbow` has at most `1` keys"},
      {R"({"minProperties": 3})", "{a: 1, b: 2}", "`rainbow` has at least `3` keys"},
      {R"({"required": ["a"]})", "{b: 2}", "`rainbow` has no `a`"},
      {R"({"dependencies": {"b": ["a"]}})", "{b: 2}", "`rainbow` has no `a`"},
      {R"({"properties": {"a": {}}, "additionalProperties": false})", "{b: 2}",
       "`rainbow` has no key `b` in its schema"},
      {R"({"properties": {"a": false}})", "{a: 2}", "`a` does not fit the schema"},
      {R"({"not": {"type": "number"}})", "2", "`rainbow` has a form that the schema excludes"},
      {R"({"anyOf": [{"type": "string"}, {"type": "array"}]})", "2",
       "`rainbow` has none of the forms that the schema allows"},
      {R"({"oneOf": [{"type": "string"}, {"type": "array"}]})", "2",
       "`rainbow` has none of the forms that the schema allows"},
      {R"({"oneOf": [{"type": "number"}, {"minimum": 1}]})", "2",
       "`rainbow` has several of the forms of which the schema allows only one"},
      {R"({"if": {"type": "number"}, "then": {"minimum": 5}})", "2",
       "`rainbow` must be at least `5`"},
      {R"({"allOf": [{"$ref": "#/definitions/big"}], "definitions": {"big": {"minimum": 5}}})", "2",
       "`rainbow` must be at least `5`"},
      {R"({"items": {"type": "number"}})", "[1, two]",
       "an item of `rainbow` must be a number, not the text `two`"},
      {R"({"patternProperties": {"^b": {"type": "string"}}})", "{bow: 2}",
       "`bow` must be a text, not `2`"},
      {R"({"patternProperties": {"^b": {}}, "additionalProperties": false})", "{bow: 2, arc: 3}",
       "`rainbow` has no key `arc` in its schema"},
      {R"({"propertyNames": {"maxLength": 3}})", "{bow: 2, arch: 3}",
       "`rainbow` has the key `arch`, whose name the schema does not allow"},
      {R"({"dependencies": {"b": {"required": ["a"]}}})", "{b: 2}", "`rainbow` has no `a`"},
  };
  for (const KeywordCase& one : cases) {
    CAPTURE(one.schema);
    const Rainbow rainbow(one.schema, one.section);
    CHECK(rainbow.is_registered);
    CHECK(rainbow.messages() == one.message + "\n");
  }
}

TEST_CASE("values that fit raise nothing, and names that YAML types are names") {
  for (const auto& one : std::vector<std::pair<std::string, std::string>>{
           {R"({"type": "integer"})", "3.0"},
           {R"({"type": "number"})", "3"},
           {R"({"type": "string", "pattern": "^[a-z]+(_[a-z]+)*$"})", "left_upper_arm"},
           {R"({"type": "string"})", "'3'"},
           {R"({"type": "null"})", "~"},
           {R"({"additionalProperties": {"$ref": "#"}})", "{a: {b: {c: {}}}}"},
           {R"({"uniqueItems": true})", "[1, 2, 3]"},
           {R"({"enum": [[1, 2], {"a": 1}]})", "{a: 1}"},
           {R"({"properties": {"a/b": {"$ref": "#/definitions/x~1y"}},
                "definitions": {"x/y": {"type": "number"}}})",
            "{a/b: 1}"},
           {"true", "anything"},
           {"type: number\nminimum: 0\n", "2"}}) {
    CAPTURE(one.first);
    const Rainbow rainbow(one.first, one.second);
    CHECK(rainbow.is_registered);
    CHECK(rainbow.messages() == "");
  }
}

TEST_CASE("a finding names the token, the schema's words and the schema's place") {
  const Rainbow rainbow(R"({"required": ["radius"], "additionalProperties": false,
  "properties": {"radius": {}, "width": {"type": "number", "description": "In metres."}}})",
                        "{width: broad, radios: 3}");
  REQUIRE(rainbow.found.size() == 2);
  const Diagnostic& type = rainbow.found[0];
  CHECK(brief(type, rainbow.sources) == "SML4301 arm_rainbow.yml:1:18");
  CHECK(type.pointer == "/rainbow/width");
  CHECK(type.help_text == "In metres.");
  REQUIRE(type.labels.size() == 1);
  CHECK(rainbow.sources.text(type.labels[0].span) == "\"type\"");
  const Diagnostic& key = rainbow.found[1];
  CHECK(key.message == "`rainbow` has no `radius`");
  CHECK(brief(key, rainbow.sources) == "SML4301 arm_rainbow.yml:1:25");
  CHECK(key.help_text == "did you mean `radius`?");
  CHECK(key.fixes.size() == 1);
}

TEST_CASE("a broken schema is reported in the schema, and checks nothing") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"type": "nunber"})", "`nunber` is not a type of JSON Schema"},
      {R"([])", "a schema must be a mapping, true or false, not a list"},
      {R"({"properties": []})", "`properties` must be a mapping of schemas, not a list"},
      {R"({"minimum": low})", "`minimum` must be a number, not the text `low`"},
      {R"({"maxItems": -1})", "`maxItems` must be a whole number from 0, not `-1`"},
      {R"({"required": a})", "`required` must be a list of names, not the text `a`"},
      {R"({"pattern": "("})", "`(` is not a regular expression: a group is not closed"},
      {R"({"pattern": "(a)\\1"})",
       "`(a)\\1` is not a regular expression: back-references are not supported"},
      {R"({"$ref": "other.json#/a"})", "`other.json#/a` does not refer to a schema in this file"},
      {R"({"$ref": "#/title", "title": "x"})", "`#/title` does not refer to a schema in this file"},
      {R"({"$ref": "#"})", "this schema applies itself to the same value again, without end"},
      {R"({"allOf": [{"anyOf": [{"$ref": "#"}]}]})",
       "this schema applies itself to the same value again, without end"},
      {R"({"propertes": {}})", "`propertes` is not a keyword of JSON Schema draft-07"},
  };
  for (const auto& one : cases) {
    CAPTURE(one.first);
    const Rainbow rainbow(one.first, "3");
    CHECK(!rainbow.is_registered);
    CHECK(rainbow.messages() == one.second + "\n");
    REQUIRE(!rainbow.found.empty());
    CHECK(rainbow.found[0].rule->id == "SML9011");
    CHECK(rainbow.sources.path(rainbow.found[0].span.source) == "rainbow.json");
  }
}

TEST_CASE("hostile schemas and data end in a finding, soon") {
  const auto begin = std::chrono::steady_clock::now();
  std::string doubling = R"({"$ref": "#/definitions/d0", "definitions": {)";
  for (int i = 0; i < 40; ++i) {
    const std::string next = R"({"$ref": "#/definitions/d)" + std::to_string(i + 1) + "\"}";
    doubling += "\"d" + std::to_string(i) + R"(": {"allOf": [)" + next + ", " + next + "]}, ";
  }
  doubling += R"("d40": {}}})";
  CHECK(!Rainbow(doubling, "3").is_registered);

  // Each level of the value doubles the work.
  const std::string twice =
      R"({"properties": {"a": {"$ref": "#"}}, "allOf": [{"properties": {"a": {"$ref": "#"}}}]})";
  const Rainbow deep(twice, repeat("{a: ", 60) + "1" + repeat("}", 60));
  CHECK(deep.messages() == "this is too large to be checked by its schema\n");

  CHECK(Rainbow(R"({"pattern": "^(a+)+$"})", repeat("a", 5000) + "b").found.size() == 1);
  CHECK(Rainbow(R"({"pattern": "^(a|a)*$"})", repeat("a", 50000)).messages() == "");
  CHECK(Rainbow("pattern: '" + repeat("a*", 140) + "b'", repeat("a", 50000)).messages() ==
        "this is too large to be checked by its schema\n");
  CHECK(Rainbow(R"({"patternProperties": {"^.*z$": false}})", "{? " + repeat("a", 30000) + "z : 1}")
            .found.size() == 1);
  CHECK(!Rainbow("pattern: (a{300}){300}", "{}").is_registered);
  CHECK(Rainbow(R"({"uniqueItems": true})", "[" + repeat("1, ", 50000) + "1]").found.size() == 1);
  CHECK(!Rainbow(repeat("{\"not\": ", 90) + "{}" + repeat("}", 90), "3").is_registered);
  CHECK(!Rainbow(repeat("[", 5000), "3").is_registered);
  const Rainbow many(R"({"items": {"type": "string"}})", "[" + repeat("1, ", 20000) + "1]");
  CHECK(many.found.size() > 100);
  const auto seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  CHECK(seconds < 60);  // without bounds: hours
}

TEST_CASE("patterns of names take linear time") {
  const auto begin = std::chrono::steady_clock::now();
  const int n = 40;
  const std::string names[] = {"^" + repeat("a?", n) + repeat("a", n) + "$",
                               "^" + repeat("(a|a)", n) + "b$", "^" + repeat("(a|)", n) + "b$",
                               "^" + repeat("[ab]?", n) + "z$", "^(a+)+$"};
  for (const std::string& name : names) {
    CAPTURE(name);
    const Rainbow rainbow("patternProperties: {'" + name + "': {}}", "{" + repeat("a", n) + ": 1}");
    CHECK(rainbow.is_registered);
    CHECK(rainbow.messages() == "");
  }
  const auto seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  CHECK(seconds < 2);  // with a backtracking matcher: months
}

namespace {

/// K lists of `size` numbers that differ in the last.
std::string lists(int count, std::size_t size, int first) {
  std::string all = "[";
  for (int i = 0; i < count; ++i) {
    all += "[" + repeat("1, ", size - 1) + std::to_string(first + i) + "], ";
  }
  return all + "]";
}

}  // namespace

TEST_CASE("deep values are compared in linear time") {
  const auto begin = std::chrono::steady_clock::now();
  const Rainbow known("items: {enum: " + lists(1900, 100, 0) + "}", lists(1900, 100, 10000));
  CHECK(known.found.size() > 1000);
  const Rainbow allowed("items: {enum: " + lists(500, 100, 0) + "}", lists(500, 100, 0));
  CHECK(allowed.messages() == "");
  CHECK(Rainbow("uniqueItems: true", lists(6000, 32, 0)).messages() == "");
  const std::string twice = lists(3000, 30, 0);
  CHECK(Rainbow("uniqueItems: true", twice.substr(0, twice.size() - 1) + twice.substr(1))
            .messages() == "`rainbow` contains an item twice\n");
  const auto seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  CHECK(seconds < 10);  // pair by pair: 35 s
}

TEST_CASE("a type with a schema is known") {
  SourceMap sources;
  DiagnosticSink sink;
  UserSchemas schemas;
  const SourceId source = sources.add("sphere.json", R"({"required": ["radius"]})");
  CHECK(schemas.add_entity_type("mesh", source, sources, sink));
  CHECK(schemas.add_entity_type("smurff", source, sources, sink));
  MemoryFiles files;
  files.add("scene.smurfs",
            "entities:\n- {name: a, type: mesh, radius: 1}\n- {name: b, type: smurff, ancor: 1}\n");
  LoadContext context{sources, files, sink, {}, {}};
  context.schemas = &schemas;
  const LinkedScene scene = load_scene("scene.smurfs", context);
  lint_scene(scene, {}, sink);
  const auto found = apply_selection(sink.take(), sources, {});
  REQUIRE(found.size() == 1);
  CHECK(brief(found[0], sources) == "SML5401 scene.smurfs:3:4");
  CHECK(found[0].message == "this value has no `radius`");
}
