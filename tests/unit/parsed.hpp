// SPDX-License-Identifier: BSD-3-Clause
// A YAML or XML text parsed alone, and its tree as lines that tests compare.
#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/xml.hpp"
#include "smurf/yaml.hpp"

namespace smurf::test {

using Lines = std::vector<std::string>;

/// One text, one item per line, because doctest shows texts but not vectors.
std::string join(const Lines& lines);
/// Makes line ends, tabs, carriage returns and the byte order mark visible.
std::string visible(std::string_view text);
/// "SML0011 3:1 [slice]" for each diagnostic, in the order of reporting.
Lines briefs(const DiagnosticSink& sink, const SourceMap& sources);

struct ParsedYaml {
  SourceMap sources;
  DiagnosticSink sink;
  std::optional<yaml::Document> document;

  explicit ParsedYaml(std::string text, const Limits& limits = {});
  yaml::View root() const { return document->view(); }
  Lines briefs() const { return test::briefs(sink, sources); }
  /// One line a node: pointer, key and value as source slices, decoded text where it differs.
  Lines lines() const;
};

struct ParsedXml {
  SourceMap sources;
  DiagnosticSink sink;
  std::optional<xml::Document> document;

  explicit ParsedXml(std::string text, const Limits& limits = {});
  xml::View root() const { return document->view(); }
  Lines briefs() const { return test::briefs(sink, sources); }
  /// One line an element and attribute.
  Lines lines() const;
};

struct ErrorCase {
  std::string text;
  Lines briefs;
  bool has_tree = false;
};

template <class Parsed>
void check_errors(const std::vector<ErrorCase>& cases) {
  for (const ErrorCase& one : cases) {
    CAPTURE(visible(one.text.substr(0, 100)));
    const Parsed parsed(one.text);
    CHECK(join(parsed.briefs()) == join(one.briefs));
    CHECK(parsed.document.has_value() == one.has_tree);
  }
}

}  // namespace smurf::test
