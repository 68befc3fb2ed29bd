// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/yaml.hpp"
#include "syntax/yaml_reader.hpp"

using namespace smurf;

TEST_CASE("quoted: short texts are whole") {
  CHECK(quoted("") == "``");
  CHECK(quoted("arm") == "`arm`");
  CHECK(shortened("abcd", 4) == "abcd");
}

TEST_CASE("quoted: of long ones the middle is left out, never part of a character") {
  CHECK(shortened("abcdefghij", 8) == "abcd…ij");
  std::string text;
  for (int i = 0; i < 1000; ++i) text += i % 3 == 0 ? "x" : i % 3 == 1 ? "ü" : "🤖";
  for (std::size_t most = 0; most < 200; ++most) {
    const std::string shown = shortened(text, most);
    CAPTURE(most);
    CHECK(!utf8::find_invalid(shown));
    CHECK(shown.size() <= most + 3);
  }
  CHECK(quoted(std::string(1'000'000, 'k')).size() < 250);
}

TEST_CASE("quoted: a message stays short, whatever it was made of") {
  DiagnosticSink sink;
  const Diagnostic& found = sink.report(*all_rules().front(), {}, std::string(1'000'000, 'k'));
  CHECK(found.message.size() < 5000);
}

TEST_CASE("quoted: pointers do not go by names that are none") {
  SourceMap sources;
  DiagnosticSink sink;
  const std::string text = "motors:\n- name: " + std::string(100'000, 'k') + "\n- name: b\n";
  const auto document = parse_yaml(sources, sources.add("a.yml", text), {}, sink);
  REQUIRE(document);
  const yaml::View motors = document->view().find("motors");
  const yaml::View first = *motors.begin();
  const yaml::View second = *++motors.begin();
  CHECK(yaml::named_pointer(*document, first.id()) == "/motors/0");
  CHECK(yaml::named_pointer(*document, second.id()) == "/motors/name=b");
}
