// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics in the lines of their files, against hand-drawn frames.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "unit/diagnosed.hpp"

using namespace smurf;
using namespace smurf::test;

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
  diagnostic.label(find(sources, urdf, "elbow_joint"), "`elbow_joint` is defined here");
  diagnostic.note("MARS drives joint 0");
  diagnostic.help("a joint with a similar name exists: `elbow_joint`");
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
  diagnostic.label(find(sources, id, "second"), "and here");
  diagnostic.label(find(sources, id, "first"), "starts here");
  diagnostic.label(find(sources, id, "7"), "the value");
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

TEST_CASE("a label on the marked token is its caption") {
  SourceMap sources;
  const SourceId yaml = sources.add("m.yml", "- joint: elbow\n");
  Diagnostic diagnostic = diagnose(find(sources, yaml, "joint"), "this motor has no `name`");
  diagnostic.label(find(sources, yaml, "joint"), "add it after this key");
  CHECK(render_full(diagnostic, sources, {}) ==
        R"(error[SML3101]: this motor has no `name`
 --> m.yml:1:3
  |
1 | - joint: elbow
  |   ^^^^^ add it after this key
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
  diagnostic.help("say \x07");
  diagnostic.note("a\r\nb");
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
  diagnostic.help("write it");
  diagnostic.label({text, 0, 1}, "named here");
  diagnostic.label({missing, 0, 0}, "this one");
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
  diagnostic.label(find(sources, id, "c"), "inside");
  diagnostic.label(find(sources, id, "d:\n  e: 3"), "other");
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
  // At the start and the end of the line, the full width is used.
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
    diagnostic.label(find(sources, id, label), std::string(label));
  }
  diagnostic.label({id, 0, 47}, "from the left");
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
    for (std::uint32_t i = pick(3); i > 0; --i) diagnostic.label(span(), "label");
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
