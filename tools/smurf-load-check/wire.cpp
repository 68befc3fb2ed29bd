// SPDX-License-Identifier: BSD-3-Clause
// A span means the same on both sides, because the child is a copy of this process.
#include "smurf-load-check/wire.hpp"

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers/numbers.hpp"

namespace smurf::load_check {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kTrace = "trace ";

Json to_json(const Span& span) {
  return {static_cast<std::uint32_t>(span.source), span.begin, span.end};
}
Span to_span(const Json& json) {
  return {SourceId{json[0].get<std::uint32_t>()}, json[1].get<std::uint32_t>(),
          json[2].get<std::uint32_t>()};
}

// Types of list items, declared here for to_list().
Json to_json(const Rule* rule);
Json to_json(const Label& label);
Json to_json(const Edit& edit);
Json to_json(const Fix& fix);
Json to_json(const Diagnostic& diagnostic);
Json to_json(const StageResult& stage);

template <class T>
Json to_list(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(to_json(value));
  return list;
}
template <class T>
std::vector<T> from_list(const Json& json, T (*to_value)(const Json&)) {
  std::vector<T> values;
  for (const Json& each : json) values.push_back(to_value(each));
  return values;
}

/// JSON has neither NaN nor infinity; both come back as NaN.
Json to_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }
double to_double(const Json& json) { return json.is_null() ? NAN : json.get<double>(); }

Json to_json(const Rule* rule) { return rule != nullptr ? Json(rule->id) : Json(); }
const Rule* to_rule(const Json& json) {
  return json.is_null() ? nullptr : find_rule(json.get<std::string>());
}

std::optional<Severity> to_severity(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return static_cast<Severity>(json.get<int>());
}

Json to_json(const Label& label) {
  const auto& [span, message] = label;
  return {to_json(span), message};
}
Label to_label(const Json& json) { return {to_span(json[0]), json[1]}; }

Json to_json(const Edit& edit) {
  const auto& [span, text] = edit;
  return {to_json(span), text};
}
Edit to_edit(const Json& json) { return {to_span(json[0]), json[1]}; }

Json to_json(const Fix& fix) {
  const auto& [applicability, edits, new_name] = fix;
  Json json = {static_cast<int>(applicability), to_list(edits)};
  if (new_name) json.push_back({to_json(new_name->among), new_name->name});
  return json;
}
Fix to_fix(const Json& json) {
  Fix fix{static_cast<Applicability>(json[0].get<int>()), from_list(json[1], to_edit), {}};
  if (json.size() > 2) fix.new_name = Fix::NewName{to_span(json[2][0]), json[2][1]};
  return fix;
}

/// The binding names every member, so a new member does not compile until it is sent. Findings of
/// the load check have no cases, and were neither located nor joined.
Json to_json(const Diagnostic& diagnostic) {
  const auto& [rule, severity, span, message, caret, pointer, named_pointer, names, cases,
               consequences, others_are, habit, others, expanded, call, untargeted, labels, notes,
               help, fixes, left_out] = diagnostic;
  assert(cases.empty() && names.empty() && others_are.empty() && habit == 0 && others.empty());
  assert(!expanded && call.empty());
  return {{"rule", to_json(rule)},
          {"severity", static_cast<int>(severity)},
          {"span", to_json(span)},
          {"message", message},
          {"caret", caret},
          {"pointer", pointer},
          {"named_pointer", named_pointer},
          {"consequences", to_list(consequences)},
          {"untargeted", untargeted ? Json(static_cast<int>(*untargeted)) : Json()},
          {"labels", to_list(labels)},
          {"notes", notes},
          {"help", help},
          {"fixes", to_list(fixes)},
          {"left_out", to_json(left_out)}};
}
Diagnostic to_diagnostic(const Json& json) {
  return {.rule = to_rule(json["rule"]),
          .severity = static_cast<Severity>(json["severity"].get<int>()),
          .span = to_span(json["span"]),
          .message = json["message"],
          .caret = json["caret"],
          .pointer = json["pointer"],
          .named_pointer = json["named_pointer"],
          .names = {},
          .consequences = from_list(json["consequences"], to_rule),
          .others_are = {},
          .others = {},
          .expanded = {},
          .call = {},
          .untargeted = to_severity(json["untargeted"]),
          .labels = from_list(json["labels"], to_label),
          .notes = json["notes"],
          .help_text = json["help"],
          .fixes = from_list(json["fixes"], to_fix),
          .left_out = to_rule(json["left_out"])};
}

Json to_json(const StageResult& stage) {
  Json figures = Json::array();
  for (const Figure& figure : stage.figures) {
    figures.push_back(
        {figure.bound, to_json(figure.value), figure.limit, figure.worst, to_json(figure.place)});
  }
  return {static_cast<int>(stage.stage), static_cast<int>(stage.verdict), stage.note, figures};
}
StageResult to_stage(const Json& json) {
  StageResult stage;
  stage.stage = static_cast<Stage>(json[0].get<int>());
  stage.verdict = static_cast<Verdict>(json[1].get<int>());
  stage.note = json[2];
  for (const Json& figure : json[3]) {
    stage.figures.push_back(
        {figure[0], to_double(figure[1]), figure[2], figure[3], to_span(figure[4])});
  }
  return stage;
}

/// Names may contain invalid UTF-8.
std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

CheckResult to_result(const Json& json) {
  CheckResult result;
  result.stages = from_list(json["stages"], to_stage);
  result.diagnostics = from_list(json["diagnostics"], to_diagnostic);
  result.is_trace_cut = json["is_trace_cut"];
  return result;
}

}  // namespace

std::string encode_begin(Stage stage) { return line({{"begin", static_cast<int>(stage)}}); }

std::string encode_fault(const std::string& message) { return line({{"fault", message}}); }

std::string encode(const CheckResult& result) {
  return line({{"stages", to_list(result.stages)},
               {"diagnostics", to_list(result.diagnostics)},
               {"is_trace_cut", result.is_trace_cut}});
}

std::string encode_trace_begin(std::size_t size) {
  return std::string(kTrace) + std::to_string(size) + "\n";
}

Message decode(std::string output) {
  Message message;
  std::size_t trace_begin = 0;
  std::size_t trace_size = 0;
  for (std::size_t begin = 0; begin < output.size();) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    if (output.compare(begin, kTrace.size(), kTrace) == 0) {
      const std::string_view line(output.data() + begin, end - begin);
      const auto size = parse_integer(line.substr(kTrace.size()));
      if (!size || end == output.size()) break;
      trace_begin = end + 1;
      trace_size = std::min(output.size() - trace_begin, static_cast<std::size_t>(*size));
      begin = trace_begin + trace_size;
      continue;
    }
    const Json json =
        Json::parse(output.begin() + static_cast<std::ptrdiff_t>(begin),
                    output.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    begin = end + 1;
    if (json.is_discarded()) break;  // the child was stopped while it wrote
    if (json.contains("begin")) {
      message.last_stage = static_cast<Stage>(json["begin"].get<int>());
      // If another stage follows, the result is not the last one.
      message.so_far = std::move(message.result).value_or(CheckResult{});
      message.result.reset();
    } else if (json.contains("fault")) {
      message.fault = json["fault"];
    } else {
      message.result = to_result(json);
    }
  }
  if (!message.result) return message;
  output.resize(trace_begin + trace_size);
  output.erase(0, trace_begin);
  message.result->trace = std::move(output);
  return message;
}

}  // namespace smurf::load_check
