// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include "ast/urdf_reader.hpp"
#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1121_xacro_definition_file {
namespace {

constexpr Circumstance kUndeclared{"prefix not declared"};
constexpr std::string_view kUndeclaredPrefix = "refuses a prefix that is not declared";

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !has_only_xacro_definitions(model.robot->document)) return;
  const xml::Document& document = model.robot->document;
  Span first;
  std::size_t count = 0;
  std::string name;
  for (std::uint32_t i = 0; i < document.elements.size(); ++i) {
    const xml::View element(document, xml::ElementId{i});
    if (!element.name().starts_with("xacro:") || count++ > 0) continue;
    first = element.name_span();
    name = element.name();
  }
  Diagnostic& diagnostic =
      findings.report(first, quoted(name) + " defines something that the robot does not use");
  if (xml::View(document, document.root).attribute("xmlns:xacro") == nullptr) {
    diagnostic.when(kUndeclared);
  }
  if (count > 1) diagnostic.note(counted(count - 1, "more definition") + " in this file");
  diagnostic.help("delete it, or run xacro and keep its output");
}

constexpr Fact kFacts[] = {
    {&readers::newton, Effect::refuses, kUndeclaredPrefix, kRun, when(kUndeclared)},
    {&readers::isaac, Effect::refuses, kUndeclaredPrefix, kRun, when(kUndeclared)},
    {&readers::urdf, Effect::takes, "ignores the definition, which would expand to nothing",
     "urdfdom, sdformat, MuJoCo, DART, run"},
};

}  // namespace

extern constinit const Rule sml1121_xacro_definition{
    .id = "SML1121",
    .name = "xacro-definition",
    .severity = Severity::info,
    .summary = "A URDF contains properties or arguments of xacro, none of which it uses.",
    .remedy = "Delete them, or run xacro and keep its output.",
    .sources = "84 files of mycobot_ros.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1121_xacro_definition_file
