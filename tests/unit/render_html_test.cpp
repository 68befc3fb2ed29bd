// SPDX-License-Identifier: BSD-3-Clause
// The data in the page of a report: it cannot leave its block or hide text, and its size is
// bounded.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/utf8.hpp"
#include "render/printable.hpp"
#include "unit/diagnosed.hpp"

using namespace smurf;
using namespace smurf::test;
using Json = nlohmann::json;

namespace {

constexpr std::string_view kBlock = R"(<script id="report" type="application/json">)";

std::string page_of(const std::vector<Diagnostic>& found, const SourceMap& sources) {
  return render_html(found, sources, summarize(found), {"smurf-lint", "0.1.0"}, {},
                     {.remarks = "a remark\n"});
}

std::string data_of(const std::string& page) {
  const std::size_t begin = page.find(kBlock);
  REQUIRE(begin != std::string::npos);
  const std::size_t first = begin + kBlock.size();
  return page.substr(first, page.find("</script>", first) - first);
}

Json read(const std::vector<Diagnostic>& found, const SourceMap& sources) {
  return Json::parse(data_of(page_of(found, sources)));
}

Json hunks(const SourceMap& sources, Span span, std::vector<Edit> edits) {
  Diagnostic diagnostic = diagnose(span, "bad");
  diagnostic.fixes.push_back({Applicability::safe, std::move(edits)});
  return read({diagnostic}, sources)["diagnostics"][0]["fix"]["hunks"];
}

}  // namespace

TEST_CASE("nothing in a report ends its block in the page, or is invisible there") {
  const std::string nasty =
      "</script><script>x</script><!-- <script> \x1b[31m\x7f\u0085\u202e\ufeff";
  SourceMap sources;
  const SourceId id = sources.add(nasty, "a: " + nasty + "\n");
  Diagnostic diagnostic = diagnose({id, 3, 9}, nasty, nasty);
  diagnostic.label({id, 0, 1}, nasty).note(nasty).help(nasty);
  diagnostic.pointer = nasty;
  diagnostic.fixes.push_back({Applicability::unsafe, {{{id, 3, 4}, nasty}}});
  const std::string page = page_of({diagnostic}, sources);
  const std::string data = data_of(page);
  CHECK(data.find('<') == std::string::npos);
  for (const std::string_view hidden : {"\x1b", "\x7f", "\u0085", "\u202e", "\ufeff"}) {
    CHECK(page.find(hidden) == std::string::npos);
  }
  const Json found = Json::parse(data)["diagnostics"][0];
  CHECK(found["message"] == render::escape(nasty));
  CHECK(found["labels"][0]["file"] == render::escape(nasty));
  const std::string shown =
      "</script><script>x</script><!-- <script> \ufffd[31m\ufffd\ufffd\ufffd\ufffd";
  CHECK(Json::parse(data)["sources"]["0"][0]["lines"] == "a: " + shown);
  CHECK(found["fix"]["hunks"][0]["after"] == "a: " + shown + shown.substr(1));
}

TEST_CASE("characters of a line in a page are where the columns of the report are") {
  CHECK(render::visible_lines("\ufeffa\r\nb\rc\t\x01é😀") == "\ufffda\nb\ufffdc\t\ufffdé😀");
  SourceMap sources;
  const std::string text = "é\xff😀\xe2\x28\x80z\n";
  const SourceId id = sources.add("a", text);
  const std::string shown = render::visible_lines(text);
  const auto at = static_cast<std::uint32_t>(text.find('z'));
  CHECK(utf8::count_code_points(shown.substr(0, shown.find('z'))) + 1 ==
        sources.position(id, at).column);
}

TEST_CASE("a page has the lines around each mark once, and both ends of long marks") {
  SourceMap sources;
  std::string text;
  for (int i = 1; i <= 100; ++i) text += std::to_string(i) + "\n";
  const SourceId id = sources.add("a", text);
  const auto line = [&](std::uint32_t number) { return sources.line_span(id, number); };
  std::vector<Diagnostic> found{diagnose(line(1), ""), diagnose(line(5), ""),
                                diagnose({id, line(20).begin, line(80).end}, ""),
                                diagnose(line(100), "")};
  found[0].label(line(90), "here");
  const Json parts = read(found, sources)["sources"]["0"];
  std::string ranges;
  for (const Json& part : parts) {
    const std::string lines = part["lines"];
    ranges +=
        std::to_string(part["first"].get<int>()) + "-" + lines.substr(lines.rfind('\n') + 1) + " ";
  }
  CHECK(ranges == "1-7 18-28 72-82 88-92 98-100 ");
}

TEST_CASE(
    "a file whose lines would make a page too large is left out, and those after it are not") {
  SourceMap sources;
  const SourceId large = sources.add("large", std::string(17'000'000, 'x'));
  const SourceId small = sources.add("small", "x");
  const Json report = read({diagnose({large, 5, 6}, ""), diagnose({small, 0, 1}, "")}, sources);
  CHECK(report["sources"]["0"] == "");
  CHECK(report["sources"]["1"][0]["lines"] == "x");
  CHECK(report["diagnostics"][0]["column"] == 6);
}

TEST_CASE("a fix is shown as lines before and after, and very long ones are cut") {
  SourceMap sources;
  const SourceId id = sources.add("a", "one\ntwo\nthree\nfour\n" + std::string(30'000, 'y') + "\n");
  const Span two = find(sources, id, "two");
  CHECK(hunks(sources, two, {{two, "2"}, {find(sources, id, "one"), "1"}}).dump() ==
        R"([{"after":"1\n2","before":"one\ntwo","file":"a","line":1}])");
  CHECK(hunks(sources, two, {{two, "2"}, {find(sources, id, "four"), "4"}}).size() == 2);

  const std::uint32_t middle = sources.line_begin(id, 5) + 15'000;
  const Json cut = hunks(sources, two, {{{id, middle, middle + 1}, "x"}});
  const std::string around(80, 'y');
  CHECK(cut[0]["before"] == "..." + around + "y" + around + "...");
  CHECK(cut[0]["after"] == "..." + around + "x" + around + "...");
  CHECK(!cut[0].contains("is_cut"));

  const Json long_text = hunks(sources, two, {{two, std::string(10'000, 'z')}});
  CHECK(long_text[0]["after"] == std::string(4000, 'z') + "...");
  CHECK(long_text[0]["is_cut"] == true);

  std::string many;
  std::vector<Edit> edits;
  for (std::uint32_t i = 0; i < 30; ++i) many += "k\n\n\n";
  const SourceId other = sources.add("b", many);
  for (std::uint32_t i = 0; i < 30; ++i) edits.push_back({{other, 4 * i, 4 * i + 1}, "m"});
  const Json first = hunks(sources, two, edits);
  CHECK(first.size() == 20);
  CHECK(first[19]["is_cut"] == true);
}

TEST_CASE("a page explains the rules of its findings, and needs no file") {
  SourceMap sources;
  const Json report = read({diagnose({SourceId{7}, 0, 1}, "nowhere")}, sources);
  CHECK(report["rules"]["SML3101"]["why"] == "MARS drives joint 0 instead.");
  CHECK(report["sources"].empty());
  CHECK(report["remarks"] == "a remark\n");
  CHECK(page_of({}, sources) == page_of({}, sources));
  CHECK(read({}, sources)["diagnostics"].empty());
}
