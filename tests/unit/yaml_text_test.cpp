// SPDX-License-Identifier: BSD-3-Clause
// Our YAML reader reads the output of the YAML writer unchanged; the output is readable for people.
#include <doctest/doctest.h>

#include <random>

#include "parsed.hpp"
#include "syntax/yaml_reader.hpp"
#include "write/text/yaml_text.hpp"

using namespace smurf;

namespace {

/// The scalar at /a after writing and reading it.
std::string read_back(const NewValue& value) {
  SourceMap sources;
  DiagnosticSink sink;
  const SourceId source = sources.add("a.yml", yaml_text(value));
  const auto document = parse_yaml(sources, source, {}, sink);
  REQUIRE_MESSAGE(document, sources.text(source));
  CHECK(sink.diagnostics().empty());
  const yaml::View scalar = document->view().find(value.key);
  REQUIRE(scalar);
  return std::string(scalar.text());
}

}  // namespace

TEST_CASE("scalars are quoted where a reader could misread them, and only there") {
  struct Row {
    const char* text;
    const char* written;
  };
  const Row rows[] = {
      {"arm", "arm"},
      {"../urdf/arm.urdf", "../urdf/arm.urdf"},
      {"left-1.2", "left-1.2"},
      {"", "''"},
      {"no", "'no'"},
      {"y", "y"},
      {"NULL", "'NULL'"},
      {"12", "'12'"},
      {"1e3", "'1e3'"},
      {".5", "'.5'"},
      {"-x", "'-x'"},
      {"a: b", "'a: b'"},
      {"it's", "'it''s'"},
      {"a #b", "'a #b'"},
      {"tab\there", "\"tab\\u0009here\""},
      {"two\nlines", "\"two\\nlines\""},
      {"\xC3\xA9t\xC3\xA9", "'\xC3\xA9t\xC3\xA9'"},
      {"next\xC2\x85line", "\"next\\u0085line\""},
      {"\xEF\xBB\xBF", "\"\\ufeff\""},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CHECK(yaml_scalar(row.text) == row.written);
    CHECK(read_back(text_value("a", row.text)) == row.text);
  }
}

TEST_CASE("numbers are numbers for YAML 1.1 as well") {
  CHECK(yaml_number(1e-6) == "1.0e-06");
  CHECK(yaml_number(1.5e-6) == "1.5e-06");
  CHECK(yaml_number(0.1) == "0.1");
  CHECK(yaml_number(3) == "3");
}

TEST_CASE("any text survives, XML with odd line breaks too") {
  for (const std::string text :
       {"<a>\n  <b/>\n\n  </a>", "<a>\r\n</a>", "<a>\n\ttab\n</a>", "<a>  \n  </a>", " <a>\n</a>",
        "<a>\n</a>\n", "\n<a/>", "<a># no comment: here\n</a>"}) {
    CAPTURE(text);
    CHECK(read_back(text_value("a", text)) == text);
  }
  std::mt19937 random(7);
  constexpr std::string_view kBytes = "a:#-'\"\\ \n\t<>{}[],&*!|%@`?~0.=\r";
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) {
      text += kBytes[random() % kBytes.size()];
    }
    CAPTURE(text);
    CHECK(read_back(text_value("a", text)) == text);
    NewValue key = text_value(text, "x");
    CHECK(read_back(key) == "x");
  }
}

TEST_CASE("keys may be longer than YAML allows before a colon") {
  for (const std::string& key :
       {std::string(3000, 'n'), std::string(999, 'n'), std::string(1100, ':')}) {
    CAPTURE(key.size());
    CHECK(read_back(text_value(key, "x")) == "x");
    NewValue in_list = list_value(
        "all",
        {mapping_value({}, {text_value(key, "x"), numbers_value(key + "2", {{key, 1}, {"b", 2}}),
                            list_value(key + "3", {text_value({}, "y")})})});
    SourceMap sources;
    DiagnosticSink sink;
    const SourceId source = sources.add("a.yml", yaml_text(in_list));
    const auto document = parse_yaml(sources, source, {}, sink);
    REQUIRE_MESSAGE(document, sources.text(source));
    CHECK(sink.diagnostics().empty());
    const yaml::View entry = *document->view().find("all").begin();
    CHECK(entry.find(key).text() == "x");
    CHECK(entry.find(key + "2").find(key).text() == "1");
    CHECK((*entry.find(key + "3").begin()).text() == "y");
  }
}

TEST_CASE("block style, comments, and things that belong together on one line") {
  NewValue motor =
      mapping_value({}, {text_value("name", "hip"), number_value("p", 10, "guessed"),
                         list_value("id", {text_value({}, "a"), text_value({}, "b")})});
  motor.comment = "from line 3";
  NewValue color = mapping_value({}, {numbers_value("color", {{"r", 1}, {"g", 0.5}})});
  CHECK(yaml_text(list_value("motors", {motor, color, mapping_value({}, {})})) ==
        "motors:\n"
        "# from line 3\n"
        "- name: hip\n"
        "  p: 10  # guessed\n"
        "  id:\n"
        "  - a\n"
        "  - b\n"
        "- color: {r: 1, g: 0.5}\n"
        "- {}\n");
  NewValue inner = mapping_value("gazebo", {text_value("xml", "<a>\n  b\n</a>")});
  inner.comment = "arm.urdf:7";
  CHECK(yaml_text(mapping_value("extensions", {inner})) == "extensions:\n"
                                                           "  # arm.urdf:7\n"
                                                           "  gazebo:\n"
                                                           "    xml: |-\n"
                                                           "      <a>\n"
                                                           "        b\n"
                                                           "      </a>\n");
}

TEST_CASE("a comment stays on its line") {
  CHECK(yaml_text(number_value("a", 1, "two\nlines\x01")) == "a: 1  # \"two\\nlines\\u0001\"\n");
  NewValue list = list_value("a", {text_value({}, "b", "x\ny")});
  CHECK(yaml_text(list) == "a:\n# \"x\\ny\"\n- b\n");
  CHECK(yaml_comment("one\ntwo") == "# one\n# two\n");
}
