// SPDX-License-Identifier: BSD-3-Clause
// Layout of the text reports, against hand-drawn frames, and the JSON report.
#include <algorithm>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "smurf/render.hpp"

using namespace smurf;

namespace {

constexpr Rule kRule{.id = "SML3101",
                     .name = "unknown-joint",
                     .severity = Severity::error,
                     .summary = "A name is not that of a joint.",
                     .why = "MARS drives joint 0 instead.",
                     .remedy = "Correct the name.",
                     .sources = "smurf.cpp:156"};
constexpr Rule kOtherRule{.id = "SML0011",
                          .name = "duplicate-key",
                          .severity = Severity::warning,
                          .summary = "",
                          .why = "",
                          .remedy = "",
                          .sources = ""};

/// The first occurrence of `token` in the source.
Span find(const SourceMap& sources, SourceId id, std::string_view token) {
  const std::size_t at = sources.text(id).find(token);
  REQUIRE(at != std::string_view::npos);
  return {id, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + token.size())};
}

Diagnostic diagnose(Span span, std::string message, std::string caret = {}) {
  Diagnostic diagnostic;
  diagnostic.rule = &kRule;
  diagnostic.severity = Severity::error;
  diagnostic.span = span;
  diagnostic.message = std::move(message);
  diagnostic.caret = std::move(caret);
  return diagnostic;
}

/// Full text of a bare diagnostic at `token` in a file `a.yml`.
std::string show(std::string_view text, std::string_view token, int width = 0) {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", std::string(text));
  return render_full(diagnose(find(sources, id, token), "bad", "here"), sources, {false, width});
}

/// The same without the header and the arrow.
std::string frame(std::string_view text, std::string_view token, int width = 0) {
  const std::string full = show(text, token, width);
  return full.substr(full.find('\n', full.find("-->")) + 1);
}

constexpr std::string_view kMotors = "motors:\n"
                                     "  - name: elbow_motor\n"
                                     "    joint: elbow_jiont\n"
                                     "    type: PID\n";

}  // namespace

TEST_CASE("a diagnostic with labels, notes, help and a fix") {
  SourceMap sources;
  const SourceId yaml = sources.add("robots/arm/smurf/arm_motors.yml", std::string(kMotors));
  const SourceId urdf =
      sources.add("robots/arm/urdf/arm.urdf", "\n\n\n\n\n\n\n\n\n\n\n\n"
                                              "  <joint name=\"elbow_joint\" type=\"revolute\">\n");
  Diagnostic diagnostic =
      diagnose(find(sources, yaml, "elbow_jiont"),
               "motor `elbow_motor` drives joint `elbow_jiont`, which the model does not define",
               "no such joint in `robots/arm/urdf/arm.urdf`");
  diagnostic.labels.push_back(
      {find(sources, urdf, "elbow_joint"), "`elbow_joint` is defined here"});
  diagnostic.notes.push_back("MARS drives joint 0");
  diagnostic.help = "a joint with a similar name exists: `elbow_joint`";
  diagnostic.fixes.push_back({Applicability::unsafe, {{diagnostic.span, "elbow_joint"}}});

  CHECK(
      render_full(diagnostic, sources, {}) ==
      R"(error[SML3101]: motor `elbow_motor` drives joint `elbow_jiont`, which the model does not define
 --> robots/arm/smurf/arm_motors.yml:3:12
  |
2 |   - name: elbow_motor
3 |     joint: elbow_jiont
  |            ^^^^^^^^^^^ no such joint in `robots/arm/urdf/arm.urdf`
4 |     type: PID
  |
  = note: MARS drives joint 0
  = help: a joint with a similar name exists: `elbow_joint` [unsafe fix]
note: `elbow_joint` is defined here
  --> robots/arm/urdf/arm.urdf:13:16
   |
13 |   <joint name="elbow_joint" type="revolute">
   |                -----------
   |

)");
  CHECK(render_concise(diagnostic, sources, {}) ==
        "robots/arm/smurf/arm_motors.yml:3:12: error[SML3101] motor `elbow_motor` drives joint "
        "`elbow_jiont`, which the model does not define (a joint with a similar name exists: "
        "`elbow_joint`)\n");
}

TEST_CASE("labels in the same file share the frame; gaps become dots, one line is filled in") {
  SourceMap sources;
  const SourceId id =
      sources.add("a.yml", "first: 1\nb: 2\nsecond: 3\nd: 4\ne: 5\nf: 6\nlast: 7\n");
  Diagnostic diagnostic = diagnose(find(sources, id, "last"), "bad");
  diagnostic.labels.push_back({find(sources, id, "second"), "and here"});
  diagnostic.labels.push_back({find(sources, id, "first"), "starts here"});
  diagnostic.labels.push_back({find(sources, id, "7"), "the value"});
  CHECK(render_full(diagnostic, sources, {}) == R"(error[SML3101]: bad
 --> a.yml:7:1
  |
1 | first: 1
  | ----- starts here
2 | b: 2
3 | second: 3
  | ------ and here
...
6 | f: 6
7 | last: 7
  | ^^^^
  |       - the value
  |

)");
}

TEST_CASE("a gutter as wide as the largest line number shown") {
  std::string text;
  for (int i = 1; i < 10; ++i) text += "x" + std::to_string(i) + ": 0\n";
  CHECK(show(text + "last: 0\n", "x9") == R"(error[SML3101]: bad
  --> a.yml:9:1
   |
 8 | x8: 0
 9 | x9: 0
   | ^^ here
10 | last: 0
   |

)");
}

TEST_CASE("what stands before the mark decides its column on the screen") {
  CHECK(frame("\ta:\tx\n", "x") == "  |\n1 | \ta:\tx\n  | \t  \t^ here\n  |\n\n");
  // Wide characters take two columns, combining marks none.
  CHECK(frame("関節: 右肘\n", "右肘") == "  |\n1 | 関節: 右肘\n  |       ^^^^ here\n  |\n\n");
  CHECK(frame("e\u0301: x\n", "x") == "  |\n1 | e\u0301: x\n  |    ^ here\n  |\n\n");
  CHECK(frame("a: x\r\nb: y\r\n", "x") == "  |\n1 | a: x\n  |    ^ here\n2 | b: y\n  |\n\n");
  CHECK(frame("\uFEFFa: x\n", "x") == "  |\n1 | a: x\n  |    ^ here\n  |\n\n");
}

TEST_CASE("nothing of a file reaches the terminal undecoded") {
  CHECK(frame("a: \x1b[31m\xff x\n", "x") ==
        "  |\n1 | a: \uFFFD[31m\uFFFD x\n  |           ^ here\n  |\n\n");
  CHECK(frame("a\u202Eb: x\n", "x") == "  |\n1 | a\uFFFDb: x\n  |      ^ here\n  |\n\n");
  CHECK(frame("a: \u0085 x\n", "x") == "  |\n1 | a: \uFFFD x\n  |      ^ here\n  |\n\n");

  SourceMap sources;
  const SourceId id = sources.add("a\nb.yml", "x");
  Diagnostic diagnostic = diagnose({id, 0, 1}, "name `a\x1b[2J\tb\u2028\xff`", "\x7f");
  diagnostic.help = "say \x07";
  diagnostic.notes.push_back("a\r\nb");
  CHECK(render_full(diagnostic, sources, {}) ==
        "error[SML3101]: name `a\\u001b[2J\\tb\\u2028\uFFFD`\n --> a\\nb.yml:1:1\n  |\n1 | x\n"
        "  | ^ \\u007f\n  |\n  = note: a\\r\\nb\n  = help: say \\u0007\n\n");
  CHECK(render_concise(diagnostic, sources, {}) ==
        "a\\nb.yml:1:1: error[SML3101] name `a\\u001b[2J\\tb\\u2028\uFFFD` (say \\u0007)\n");
}

TEST_CASE("places without characters") {
  SourceMap sources;
  const SourceId text = sources.add("a.yml", "a: 1\nb: 2");
  const SourceId ended = sources.add("b.yml", "a: 1\n");
  const SourceId empty = sources.add("empty.yml", "");
  const SourceId missing = sources.add_unreadable("missing.yml");
  const auto full = [&](Span span) {
    const std::string shown = render_full(diagnose(span, "bad"), sources, {});
    return shown.substr(shown.find('\n') + 1);
  };
  CHECK(full({text, 10, 10}) == " --> a.yml:2:5\n  |\n1 | a: 1\n2 | b: 2\n  |     ^\n  |\n\n");
  CHECK(full({text, 8, 99}) == " --> a.yml:2:4\n  |\n1 | a: 1\n2 | b: 2\n  |    ^\n  |\n\n");
  CHECK(full({text, 4, 4}) == " --> a.yml:1:5\n  |\n1 | a: 1\n  |     ^\n2 | b: 2\n  |\n\n");
  CHECK(full({text, 4, 5}) == " --> a.yml:1:5\n  |\n1 | a: 1\n  |     ^\n2 | b: 2\n  |\n\n");
  CHECK(full({ended, 5, 5}) == " --> b.yml:2:1\n  |\n1 | a: 1\n2 |\n  | ^\n  |\n\n");
  CHECK(full({empty, 0, 0}) == " --> empty.yml\n\n");
  CHECK(full({missing, 0, 0}) == " --> missing.yml\n\n");
  CHECK(full({SourceId{99}, 0, 0}) == "\n");
  CHECK(render_concise(diagnose({missing, 0, 0}, "bad"), sources, {}) ==
        "missing.yml:1:1: error[SML3101] bad\n");

  Diagnostic diagnostic = diagnose({missing, 0, 0}, "cannot read");
  diagnostic.help = "write it";
  diagnostic.labels.push_back({{text, 0, 1}, "named here"});
  diagnostic.labels.push_back({{missing, 0, 0}, "this one"});
  CHECK(render_full(diagnostic, sources, {}) == R"(error[SML3101]: cannot read
 --> missing.yml
  = help: write it
note: named here
 --> a.yml:1:1
  |
1 | a: 1
  | -
  |
note: this one
 --> missing.yml

)");
}

TEST_CASE("a mark of several lines has a bracket in the margin") {
  CHECK(frame("a:\n  - b: 1\n    c: 2\nd: 3\n", "- b: 1\n    c: 2") == R"(  |
1 |   a:
2 | /   - b: 1
3 | |     c: 2
  | |________^ here
4 |   d: 3
  |

)");
  // Opened in the middle of a line.
  CHECK(frame("rotation: [1,\n  2]\n", "[1,\n  2]") == R"(  |
1 |   rotation: [1,
  |  ___________^
2 | |   2]
  | |____^ here
  |

)");
  CHECK(frame("1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n", "2\n3\n4\n5\n6\n7\n8\n9") == R"(   |
 1 |   1
 2 | / 2
 3 | | 3
 4 | | 4
 5 | | 5
...  |
 8 | | 8
 9 | | 9
   | |_^ here
10 |   10
   |

)");
  // A mark up to a line end does not reach the next line.
  CHECK(frame("a: 1\nb: 2\n", "a: 1\n") == "  |\n1 | a: 1\n  | ^^^^ here\n2 | b: 2\n  |\n\n");
}

TEST_CASE("other marks beside a bracket, and labels of several lines") {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", "a:\n  b: 1\n  c: 2\nd:\n  e: 3\n");
  Diagnostic diagnostic = diagnose(find(sources, id, "b: 1\n  c: 2"), "bad");
  diagnostic.labels.push_back({find(sources, id, "c"), "inside"});
  diagnostic.labels.push_back({find(sources, id, "d:\n  e: 3"), "other"});
  CHECK(render_full(diagnostic, sources, {}) == R"(error[SML3101]: bad
 --> a.yml:2:3
  |
1 |   a:
2 | /   b: 1
3 | |   c: 2
  | |   - inside
  | |______^
4 |   d:
  |   -- other
  |

)");
}

TEST_CASE("long lines are cut on a terminal only") {
  const std::string before(100, 'a');
  const std::string after(100, 'b');
  const std::string line = before + " token " + after + "\n";
  CHECK(frame(line, "token") ==
        "  |\n1 | " + line + "  | " + std::string(101, ' ') + "^^^^^ here\n  |\n\n");
  CHECK(frame(line, "token", 40) == "  |\n"
                                    "1 | ...aaaaaaaaaaa token bbbbbbbbbbbb...\n"
                                    "  |                ^^^^^ here\n"
                                    "  |\n\n");
  // At the start and at the end of the line the room is used.
  CHECK(frame("token " + after + "\n", "token", 40) ==
        "  |\n1 | token bbbbbbbbbbbbbbbbbbbbbbbb...\n  | ^^^^^ here\n  |\n\n");
  CHECK(frame(before + " token\n", "token", 40) ==
        "  |\n1 | ..." + std::string(24, 'a') + " token\n  | " + std::string(28, ' ') +
            "^^^^^\n  | " + std::string(28, ' ') + "here\n  |\n\n");
  // Neighbours are cut at their end.
  CHECK(frame(before + "\ntoken\n", "token", 40) ==
        "  |\n1 | " + std::string(30, 'a') + "...\n2 | token\n  | ^^^^^ here\n  |\n\n");
  for (int width = 1; width < 130; ++width) {
    const std::string narrow = frame("x" + line, line.substr(90, 30), width);
    CHECK(narrow.find("^") != std::string::npos);
  }
}

TEST_CASE("a file of one endless line is not printed whole for each finding") {
  const std::string filler(300000, 'x');
  const std::string shown = frame(filler + " 肘 " + filler, "肘");
  CHECK(shown.size() < 5000);
  CHECK(shown.find(" 肘 xxx") != std::string::npos);
  CHECK(frame(filler + " 肘 " + filler, "肘", 40) == R"(  |
1 | ...xxxxxxxxxxxxx 肘 xxxxxxxxxxxxx...
  |                  ^^ here
  |

)");
}

TEST_CASE("marks in the part of a line that is cut away are drawn under the dots") {
  SourceMap sources;
  const std::string filler(30, 'x');
  const SourceId id = sources.add("a.yml", "left " + filler + " near token " + filler + " right\n");
  Diagnostic diagnostic = diagnose(find(sources, id, "token"), "bad");
  for (const std::string_view label : {"left", "near", "right"}) {
    diagnostic.labels.push_back({find(sources, id, label), std::string(label)});
  }
  diagnostic.labels.push_back({{id, 0, 47}, "from the left"});
  const std::string shown = render_full(diagnostic, sources, {false, 34});
  CHECK(shown.substr(shown.find("  |")) == R"(  |
1 | ...xxxxxx near token xxxxxx...
  |                ^^^^^
  | --- left
  | ---------------------
  | from the left
  |           ---- near
  |                            ---
  |                          right
  |

)");
}

TEST_CASE("any bytes, any marks, any width: lines of printable text") {
  std::mt19937 random(20240612);
  const auto pick = [&](std::uint32_t count) {
    return static_cast<std::uint32_t>(random()) % count;
  };
  constexpr std::string_view kPieces[] = {
      "a",    " ",     "\t", "\n", "\r\n", "\xff", "é", "肘", "\xF0\x9F\xA4\x96", "\xE2\x80\xAE",
      "\x1b", "\u0301"};
  for (int round = 0; round < 2000; ++round) {
    SourceMap sources;
    std::string text;
    for (std::uint32_t i = pick(60); i > 0; --i) text += kPieces[pick(std::size(kPieces))];
    const SourceId id = sources.add("a.yml", text);
    const auto span = [&] {
      const std::uint32_t begin = pick(static_cast<std::uint32_t>(text.size()) + 2);
      return Span{id, begin, begin + pick(40)};
    };
    Diagnostic diagnostic = diagnose(span(), "bad", "here");
    for (std::uint32_t i = pick(3); i > 0; --i) diagnostic.labels.push_back({span(), "label"});
    const std::string shown = render_full(diagnostic, sources, {false, static_cast<int>(pick(60))});
    CAPTURE(text);
    CHECK(std::none_of(shown.begin(), shown.end(), [](char c) {
      return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == '\x7f';
    }));
    CHECK(shown.find(" \n") == std::string::npos);
    const std::vector<Diagnostic> diagnostics{diagnostic};
    CHECK(nlohmann::json::accept(render_json(diagnostics, sources, {}, {"tool", "0"})));
  }
}

TEST_CASE("a text that does not fit beside its mark stands below it") {
  SourceMap sources;
  const SourceId id = sources.add("a.urdf", "<mesh filename=\"../meshes/a.stl\"/>\n");
  const Diagnostic diagnostic =
      diagnose(find(sources, id, "../meshes/a.stl"), "bad", "resolved to `robots/meshes/a.stl`");
  const auto full = [&](int width) {
    const std::string shown = render_full(diagnostic, sources, {false, width});
    return shown.substr(shown.find("  |"));
  };
  CHECK(full(0) == full(80));
  CHECK(full(60) == R"(  |
1 | <mesh filename="../meshes/a.stl"/>
  |                 ^^^^^^^^^^^^^^^
  |                 resolved to `robots/meshes/a.stl`
  |

)");
  CHECK(full(44) == R"(  |
1 | <mesh filename="../meshes/a.stl"/>
  |                 ^^^^^^^^^^^^^^^
  |        resolved to `robots/meshes/a.stl`
  |

)");
}

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
  CHECK(help({{{id, 2, 2}, "#"}, {{id, 3, 3}, "#"}}) == "  = help: a fix is known [safe fix]\n\n");
  CHECK(help({{{id, 2, 3}, std::string(61, 'x')}}) == "  = help: a fix is known [safe fix]\n\n");
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
  CHECK(page.find("\n  MuJoCo (visual): discards visuals\n") != std::string::npos);
  CHECK(render_rule(*find_rule("SML1912"), {})
            .starts_with("SML1912 mesh-package-uri-unread (error, with --target)\n"));
}

TEST_CASE("targets have a line each, and the first reason below it") {
  const Reader reader{.name = "abc", .title = "Abc", .basis = "1.0", .facts = {}};
  const Reader other{.name = "defghi", .title = "Def", .basis = "2.0", .facts = {}};
  const ReaderFact fact{.rule = "SML3101",
                        .effect = Effect::loses,
                        .makes = "leaves the motor out, and with it the controller that would "
                                 "have moved the joint",
                        .source = "abc.cpp:1"};
  SourceMap sources;
  const Diagnostic diagnostic = diagnose({sources.add("a.yml", "x: y"), 3, 4}, "bad");
  const std::vector<TargetVerdict> targets = {{&reader, 0, 2, &diagnostic, &fact},
                                              {&other, 0, 0, nullptr, nullptr}};
  CHECK(render_targets(targets, sources, {}) ==
        "abc     takes it with losses (2)\n"
        "        a.yml:1:4: leaves the motor out, and with it the controller that would\n"
        "        have moved the joint (SML3101)\n"
        "defghi  takes it\n");
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
  rule.id = "SML9999";  // no reader is known to do anything about it
  CHECK(render_rule(rule, {}) == R"(SML9999 unknown-joint (error)

A name is not that of a joint.

Why it matters
  MARS drives joint 0 instead.

What to do
  Correct the name.

Sources
  smurf.cpp:156
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
        "SML0011  warning  duplicate-key: \n"
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
  diagnostic.help = "do";
  diagnostic.notes = {"one", "two"};
  diagnostic.labels.push_back({{id, 0, 2}, "key"});
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
