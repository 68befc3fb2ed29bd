// SPDX-License-Identifier: BSD-3-Clause
// Everything but the findings themselves: fixes, summaries, pages of rules, and the JSON report.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "unit/diagnosed.hpp"

using namespace smurf;
using namespace smurf::test;

TEST_CASE("a fix without help describes itself") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a & b\n");
  const auto help = [&](std::vector<Edit> edits) {
    Diagnostic diagnostic = diagnose({id, 2, 3}, "bad");
    diagnostic.fixes.push_back({Applicability::safe, std::move(edits)});
    const std::string shown = render_full(diagnostic, sources, {});
    return shown.substr(shown.find("  = "));
  };
  CHECK(help({{{id, 2, 3}, "&amp;"}}) == "  = help: write `&amp;` [safe fix]\n\n");
  CHECK(help({{{id, 2, 4}, ""}}) == "  = help: delete `& ` [safe fix]\n\n");
  CHECK(help({{{id, 2, 2}, "#"}}) == "  = help: insert `#` [safe fix]\n\n");
  CHECK(help({{{id, 2, 2}, "#"}, {{id, 3, 3}, "#"}}) ==
        "  = help: see the fix with `--diff` [safe fix]\n\n");
  CHECK(help({{{id, 2, 3}, std::string(61, 'x')}}) ==
        "  = help: see the fix with `--diff` [safe fix]\n\n");
}

TEST_CASE("the first sentence of the remedy is the help of an error or a warning without one") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a: 1\n");
  Rule rule = kRule;
  rule.remedy = "Write 0.5, e.g. in metres. Delete it elsewhere.";
  Diagnostic diagnostic = diagnose({id, 0, 1}, "bad");
  diagnostic.rule = &rule;
  const auto has = [&](std::string_view help) {
    return render_full(diagnostic, sources, {}).find(help) != std::string::npos;
  };
  CHECK(has("  = help: write 0.5, e.g. in metres\n\n"));
  rule.remedy = "SDF needs it.";
  CHECK(has("  = help: SDF needs it\n\n"));
  diagnostic.severity = Severity::info;
  CHECK(!has("help"));
  diagnostic.severity = Severity::warning;
  diagnostic.help("known better");
  CHECK(has("  = help: known better\n\n"));
  diagnostic.help_text.clear();
  diagnostic.fixes.push_back({Applicability::safe, {{{id, 0, 1}, "b"}}});
  CHECK(has("  = help: write `b` [safe fix]\n\n"));
}

TEST_CASE("findings that differ in one name are one") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a: 1\n");
  std::vector<Diagnostic> found;
  for (const char* name : {"x", "y", "z", "u"}) {
    found.push_back(diagnose({id, 0, 1}, "the joint `" + std::string(name) + "` is fixed here"));
  }
  GroupedFindings grouped = render_grouped(found, sources, 30, {});
  CHECK(!grouped.is_complete);
  CHECK(
      grouped.text.starts_with("error[SML3101]: 4 joints (`x`, `y` and 2 more) are fixed here\n"));
  found.resize(2);
  CHECK(render_grouped(found, sources, 30, {})
            .text.starts_with("error[SML3101]: 2 joints (`x` and `y`) are fixed here\n"));
  found.resize(1);
  CHECK(render_grouped(found, sources, 30, {}).is_complete);
  // Other sentences keep the first message.
  found = {diagnose({id, 0, 1}, "`x` fell"), diagnose({id, 0, 1}, "`y` fell")};
  CHECK(render_grouped(found, sources, 30, {})
            .text.find("= note: 1 more finding like this one: `y`") != std::string::npos);
  // Too few lines: no source, then a count.
  for (int i = 0; i < 30; ++i) {
    found.push_back(diagnose({id, 0, 1}, "fell " + std::to_string(i)));
  }
  grouped = render_grouped(found, sources, 20, {});
  CHECK(std::count(grouped.text.begin(), grouped.text.end(), '\n') <= 20);
  CHECK(grouped.text.find("\n... and 22 findings of 22 other kinds\n") != std::string::npos);
}

TEST_CASE("colour only when asked for") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a: 1\n");
  const Diagnostic diagnostic = diagnose({id, 0, 1}, "bad");
  CHECK(render_full(diagnostic, sources, {}).find('\x1b') == std::string::npos);
  CHECK(render_full(diagnostic, sources, {true, 0}) ==
        "\x1b[1;31merror[SML3101]\x1b[0m\x1b[1m: bad\x1b[0m\n"
        " \x1b[34m-->\x1b[0m a.yml:1:1\n"
        "\x1b[34m  |\x1b[0m\n"
        "\x1b[34m1 |\x1b[0m a: 1\n"
        "\x1b[34m  |\x1b[0m \x1b[1;31m^\x1b[0m\n"
        "\x1b[34m  |\x1b[0m\n\n");
  CHECK(render_concise(diagnostic, sources, {true, 0}) ==
        "a.yml:1:1: \x1b[1;31merror\x1b[0m[SML3101] bad\n");
}

TEST_CASE("the summary counts in English") {
  CHECK(render_summary({}, {}) == "no findings in 0 files\n");
  CHECK(render_summary({.files = 14, .models = 1}, {}) == "no findings in 14 files (1 model)\n");
  CHECK(render_summary({.errors = 1, .files = 1}, {}) == "found 1 error in 1 file\n");
  CHECK(render_summary({.errors = 7, .warnings = 1, .files = 3, .models = 1, .scenes = 2}, {}) ==
        "found 7 errors and 1 warning in 3 files (1 model, 2 scenes)\n");
  CHECK(render_summary(
            {.errors = 1, .warnings = 2, .infos = 3, .suppressed = 4, .files = 5, .scenes = 1},
            {}) == "found 1 error, 2 warnings and 3 infos in 5 files (1 scene)\n4 suppressed\n");
}

TEST_CASE("the page of a rule says what readers make of it") {
  const std::string page = render_rule(*find_rule("SML1604"), {});
  CHECK(page.find("\nWhat readers make of it\n") != std::string::npos);
  CHECK(page.find("\n  Drake (mesh): refuses the file\n") != std::string::npos);
  CHECK(render_rule(*find_rule("SML1912"), {})
            .starts_with("SML1912 mesh-package-uri-unread (error, with --target)\n"));
}

TEST_CASE("targets have a line each, and the first reason below it") {
  const Reader reader{.name = "abc", .title = "Abc", .basis = "1.0"};
  const Reader other{.name = "defghi", .title = "Def", .basis = "2.0"};
  const Fact fact{.reader = &reader,
                  .effect = Effect::loses,
                  .makes = "leaves the motor out, and with it the controller that would have moved "
                           "the joint",
                  .evidence = "abc.cpp:1"};
  SourceMap sources;
  const Diagnostic diagnostic = diagnose({sources.add("a.yml", "x: y"), 3, 4}, "bad");
  const TargetVerdict losing{.reader = &reader,
                             .losses = 2,
                             .fact = &fact,
                             .rule = diagnostic.rule,
                             .span = diagnostic.span};
  const std::vector<TargetVerdict> targets = {losing, {.reader = &other}};
  CHECK(render_targets(targets, sources, {}) ==
        "abc     loads, with losses (2)\n"
        "        a.yml:1:4: leaves the motor out, and with it the controller that would\n"
        "        have moved the joint (SML3101)\n"
        "defghi  loads\n");
}

TEST_CASE("one line says that the verdict of a later release is different") {
  const Reader old_release{.name = "abc:1"}, same{.name = "abc:2"}, other{.name = "abc:3"};
  const Reader* const releases[] = {&old_release, &same, &other};
  const Reader reader{.name = "abc", .title = "Abc", .basis = "1.0", .releases = releases};
  const auto text = [&](std::size_t refusals) {
    TargetVerdict verdict{.reader = &reader, .losses = 1};
    verdict.newer = {{.reader = &same, .losses = 1}, {.reader = &other, .refusals = refusals}};
    return render_targets(std::vector{verdict}, SourceMap(), {});
  };
  CHECK(text(0) == "abc  loads, with losses (1)\n     abc:1 is meant; abc:3: loads\n");
  CHECK(text(2) == "abc  loads, with losses (1)\n     abc:1 is meant; abc:3: fails to load (2)\n");
}

TEST_CASE("a verdict may be that it is not known, and says what was suppressed") {
  const Reader reader{.name = "abc", .title = "Abc", .basis = "1.0"};
  const auto line = [&](TargetVerdict verdict) {
    verdict.reader = &reader;
    return render_targets(std::vector{verdict}, SourceMap(), {});
  };
  CHECK(line({.unknown = 3, .losses = 1, .unknown_rules = {&kRule, &kOtherRule}}) ==
        "abc  not known (3): SML3101 unknown-joint, SML0011 duplicate-key\n");
  CHECK(line({.refusals = 1, .unknown = 1, .in_baseline = 1}) ==
        "abc  fails to load (1, in the baseline)\n");
  CHECK(line({.refusals = 3, .ignored = 2, .in_baseline = 1}) ==
        "abc  fails to load (3, 2 ignored by a comment, 1 in the baseline)\n");
}

TEST_CASE("statistics list the most frequent rule first") {
  std::vector<Diagnostic> diagnostics(12, diagnose({}, "bad"));
  diagnostics[3].rule = &kOtherRule;
  diagnostics[3].severity = Severity::warning;
  CHECK(summarize(diagnostics).errors == 11);
  CHECK(summarize(diagnostics).warnings == 1);
  CHECK(render_statistics(diagnostics, {}) == "11  error    SML3101 unknown-joint\n"
                                              " 1  warning  SML0011 duplicate-key\n");
}

TEST_CASE("the page of a rule is wrapped at 80 columns") {
  Rule rule = kRule;
  rule.remedy = "Correct the name.";
  rule.id = "SML9999";  // no reader has a fact about it
  CHECK(render_rule(rule, {}) == R"(SML9999 unknown-joint (error)

A name is not that of a joint.

Why it matters
  MARS drives joint 0 instead.

What to do
  Correct the name.

Sources
  smurf.cpp:156.
)");
  std::string why;
  for (int i = 0; i < 100; ++i) why += "word ";
  rule.why = why;
  const std::string page = render_rule(rule, {});
  for (std::size_t at = 0, end = 0; at < page.size(); at = end + 1) {
    end = page.find('\n', at);
    CHECK(end - at <= 80);
  }
  const std::vector<const Rule*> rules{&kOtherRule, &kRule};
  CHECK(render_rule_list(rules, {}) ==
        "SML0011  warning  duplicate-key:\n"
        "SML3101  error    unknown-joint: A name is not that of a joint.\n");
  const auto list = nlohmann::json::parse(render_rule_list_json(rules));
  CHECK(list.size() == 2);
  CHECK(list[1]["name"] == "unknown-joint");
}

TEST_CASE("the JSON report keeps the order of the contract and leaves out what is empty") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "é: b\n");
  Diagnostic diagnostic = diagnose({id, 4, 5}, "bad \xff");
  const std::vector<Diagnostic> plain{diagnostic};
  const ToolName tool{"smurf-lint", "0.1.0"};
  CHECK(render_json(plain, sources, {.errors = 1, .files = 1}, tool) == R"({
  "schema_version": "1.0",
  "tool": {
    "name": "smurf-lint",
    "version": "0.1.0"
  },
  "summary": {
    "error": 1,
    "warning": 0,
    "info": 0,
    "suppressed": 0,
    "files": 1,
    "models": 0,
    "scenes": 0
  },
  "diagnostics": [
    {
      "id": "SML3101",
      "name": "unknown-joint",
      "severity": "error",
      "message": "bad �",
      "file": "a.yml",
      "line": 1,
      "column": 4,
      "end_line": 1,
      "end_column": 5
    }
  ]
}
)");

  diagnostic.pointer = "/é";
  diagnostic.help("do");
  diagnostic.notes = {"one", "two"};
  diagnostic.label({id, 0, 2}, "key");
  diagnostic.fixes.push_back({Applicability::safe, {{{id, 4, 5}, "c"}}});
  const std::vector<Diagnostic> rich{diagnostic};
  const auto report =
      nlohmann::ordered_json::parse(render_json(rich, sources, summarize(rich), tool));
  const auto& found = report["diagnostics"][0];
  std::string keys;
  for (const auto& [key, value] : found.items()) keys += key + " ";
  CHECK(keys == "id name severity message file line column end_line end_column pointer help notes "
                "labels fix ");
  CHECK(found["labels"].dump() ==
        R"([{"file":"a.yml","line":1,"column":1,"end_line":1,"end_column":2,"message":"key"}])");
  CHECK(found["fix"].dump() ==
        R"({"applicability":"safe","edits":[{"file":"a.yml","begin":4,"end":5,"text":"c"}]})");
  CHECK(render_json({}, sources, {}, tool).find("\"diagnostics\": []") != std::string::npos);
}

TEST_CASE("reports that are written finding by finding look as if they were printed as a whole") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a: b\nc: d\n");
  const ToolName tool{"smurf-lint", "0.1.0"};
  const std::vector<const Rule*> rules{&kRule};
  const RepositoryPath in_repository = [](const std::string& path) { return path; };
  std::vector<Diagnostic> found;
  for (std::size_t count = 0; count < 4; ++count) {
    CAPTURE(count);
    const std::string texts[] = {render_json(found, sources, {}, tool),
                                 render_losses_json(found, sources, tool),
                                 render_gitlab(found, sources, in_repository),
                                 render_sarif(found, sources, rules, tool, "home", in_repository)};
    for (const std::string& text : texts) {
      CHECK(nlohmann::ordered_json::parse(text).dump(2) + "\n" == text);
    }
    found.push_back(diagnose({id, 0, 1}, "\n  \"diagnostics\": []\n  \"results\": [\"losses\": ["));
    found.back().label({id, 5, 6}, "here");
    found.back().fixes.push_back({Applicability::safe, {{{id, 0, 1}, "x"}}});
  }
}
