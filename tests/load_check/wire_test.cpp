// SPDX-License-Identifier: BSD-3-Clause
// Results sent by a child arrive unchanged, for all numbers.
#include "smurf-load-check/wire.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "base/findings/rules.hpp"

using namespace smurf;
using namespace smurf::load_check;

namespace {

CheckResult some_result() {
  CheckResult result;
  result.stages.push_back(
      {Stage::hang, Verdict::fail, {{"gap", 0.25, 0.001, "joint `a`", {}}}, ""});
  DiagnosticSink sink;
  Diagnostic& diagnostic = sink.report(rules::sml6401_joint_comes_apart, {SourceId{0}, 3, 7}, "x");
  diagnostic.caret = "y";
  diagnostic.label({SourceId{0}, 8, 9}, "z");
  diagnostic.note("n");
  result.diagnostics = sink.take();
  return result;
}

}  // namespace

TEST_CASE("a result arrives as it was sent") {
  const Message message = decode(encode_begin(Stage::hang) + encode(some_result()));
  CHECK(message.last_stage == Stage::hang);
  REQUIRE(message.result);
  const CheckResult& result = *message.result;
  REQUIRE(result.stages.size() == 1);
  CHECK(result.stages[0].verdict == Verdict::fail);
  CHECK(result.stages[0].figures[0].value == 0.25);
  CHECK(result.stages[0].figures[0].worst == "joint `a`");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].rule == &rules::sml6401_joint_comes_apart);
  CHECK(result.diagnostics[0].span.begin == 3);
  CHECK(result.diagnostics[0].caret == "y");
  CHECK(result.diagnostics[0].labels[0].message == "z");
  CHECK(result.diagnostics[0].notes[0] == "n");
  CHECK(result.trace.empty());
}

TEST_CASE("a trace arrives as it was sent, whatever names are in it") {
  CheckResult sent = some_result();
  sent.is_trace_cut = true;
  const std::string rows = "{\"a\": 1}\ntrace 3\nb\n";
  const Message message =
      decode(encode_begin(Stage::hang) + encode_trace_begin(rows.size()) + rows + encode(sent));
  REQUIRE(message.result);
  CHECK(message.result->trace == rows);
  CHECK(message.result->is_trace_cut);
}

TEST_CASE("a trace that the child could not finish is no result") {
  const std::string whole =
      encode_begin(Stage::hang) + encode_trace_begin(4) + "a,b\n" + encode({});
  for (std::size_t size = 0; size < whole.size() - 1; ++size) {
    CHECK(!decode(whole.substr(0, size)).result);
  }
}

TEST_CASE("all that a finding says arrives") {
  // A new member does not compile here until the test compares it.
  const auto parts = [](const Diagnostic& diagnostic) {
    const auto& [rule, severity, span, message, caret, pointer, named_pointer, names, cases,
                 consequences, others_are, habit, others, expanded, call, untargeted, labels, notes,
                 help, fixes, left_out] = diagnostic;
    const auto place = [](const Span& s) { return std::tuple(s.source, s.begin, s.end); };
    std::vector<std::string> texts = {message, caret, pointer, named_pointer, help};
    texts.insert(texts.end(), notes.begin(), notes.end());
    std::vector<decltype(place(span))> places = {place(span)};
    for (const Label& label : labels) {
      texts.push_back(label.message);
      places.push_back(place(label.span));
    }
    std::vector<Applicability> applicabilities;
    for (const Fix& fix : fixes) {
      applicabilities.push_back(fix.applicability);
      for (const Edit& edit : fix.edits) {
        texts.push_back(edit.text);
        places.push_back(place(edit.span));
      }
    }
    return std::tuple(rule, severity, texts, consequences, untargeted, places, applicabilities,
                      left_out);
  };
  const auto at = [](std::uint32_t begin) { return Span{SourceId{2}, begin, begin + 3}; };
  const Diagnostic sent{.rule = &rules::sml6401_joint_comes_apart,
                        .severity = Severity::info,
                        .span = at(1),
                        .message = "message",
                        .caret = "caret",
                        .pointer = "/robot",
                        .named_pointer = "/robot/name",
                        .names = {},
                        .consequences = {&rules::sml6402_energy_grows},
                        .others_are = {},
                        .others = {},
                        .expanded = {},
                        .call = {},
                        .untargeted = Severity::warning,
                        .labels = {{at(10), "first"}, {at(20), "second"}},
                        .notes = {"one", "two"},
                        .help_text = "help",
                        .fixes = {{Applicability::safe, {{at(30), "edit"}, {at(40), "more"}}}},
                        .left_out = &rules::sml6402_energy_grows};
  CheckResult result;
  result.diagnostics = {sent};
  const Message message = decode(encode(result));
  REQUIRE(message.result);
  REQUIRE(message.result->diagnostics.size() == 1);
  CHECK((parts(message.result->diagnostics[0]) == parts(sent)));
}

TEST_CASE("numbers that JSON does not know arrive as NaN") {
  for (const double strange : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    CheckResult sent = some_result();
    sent.stages[0].figures[0].value = strange;
    const Message message = decode(encode(sent));
    REQUIRE(message.result);
    CHECK(std::isnan(message.result->stages[0].figures[0].value));
  }
}

TEST_CASE("what a child could not finish is not lost") {
  const std::string whole = encode(some_result());
  const Message message = decode(encode_begin(Stage::hang) + whole + encode_begin(Stage::drop) +
                                 encode_fault("assertion") + whole.substr(0, whole.size() / 2));
  CHECK(message.last_stage == Stage::drop);
  CHECK(message.fault == "assertion");
  REQUIRE(message.so_far.stages.size() == 1);
  CHECK(message.so_far.stages[0].stage == Stage::hang);
  CHECK(message.so_far.diagnostics.size() == 1);
  CHECK(!message.result);
}
