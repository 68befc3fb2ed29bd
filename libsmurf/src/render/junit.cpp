// SPDX-License-Identifier: BSD-3-Clause
// Clean files are test cases too, so that a successful run shows which files it has checked.
#include <algorithm>
#include <map>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/edits.hpp"
#include "base/text/utf8.hpp"
#include "render/json_text.hpp"
#include "render/printable.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

/// Text for XML: control characters and invalid bytes become visible.
std::string xml_text(std::string_view text) { return escape_xml(render::escape(text)); }

struct TestCase {
  std::vector<const Diagnostic*> failures;
  std::vector<const Diagnostic*> others;
};

std::string lines(const std::vector<const Diagnostic*>& diagnostics, const SourceMap& sources) {
  std::string out;
  for (const Diagnostic* diagnostic : diagnostics) {
    std::string line = render_concise(*diagnostic, sources, {});
    line.pop_back();
    out += escape_xml(line) + "\n";
  }
  return out;
}

std::string to_xml(const std::string& path, const TestCase& test, const SourceMap& sources,
                   const ToolName& tool) {
  std::string out =
      "    <testcase classname=\"" + std::string(tool.name) + "\" name=\"" + xml_text(path) + "\"";
  if (test.failures.empty() && test.others.empty()) return out + "/>\n";
  out += ">\n";
  if (!test.failures.empty()) {
    const auto* worst = *std::max_element(
        test.failures.begin(), test.failures.end(),
        [](const Diagnostic* a, const Diagnostic* b) { return a->severity < b->severity; });
    out += "      <failure message=\"" + counted(test.failures.size(), "finding") + "\" type=\"" +
           std::string(to_string(worst->severity)) + "\">" + lines(test.failures, sources) +
           "</failure>\n";
  }
  if (!test.others.empty()) {
    out += "      <system-out>" + lines(test.others, sources) + "</system-out>\n";
  }
  return out + "    </testcase>\n";
}

}  // namespace

std::string render_junit(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         const ToolName& tool, std::optional<Severity> least_failure) {
  std::map<std::string, TestCase> tests;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const SourceId source{static_cast<std::uint32_t>(i)};
    if (sources.is_readable(source)) tests[sources.path(source)];
  }
  for (const Diagnostic& diagnostic : diagnostics) {
    TestCase& test = tests[render::path_of(diagnostic.span, sources)];
    const bool is_failure = least_failure && diagnostic.severity >= *least_failure;
    (is_failure ? test.failures : test.others).push_back(&diagnostic);
  }
  std::string cases;
  std::size_t failures = 0;
  for (const auto& [path, test] : tests) {
    failures += test.failures.empty() ? 0 : 1;
    cases += to_xml(path, test, sources, tool);
  }
  const std::string counts = " tests=\"" + std::to_string(tests.size()) + "\" failures=\"" +
                             std::to_string(failures) + "\"";
  const std::string name = " name=\"" + std::string(tool.name) + "\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + name + counts +
         ">\n  <testsuite" + name + counts + ">\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace smurf
