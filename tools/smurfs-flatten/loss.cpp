// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/loss.hpp"

#include "common/converter.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

std::optional<std::string> loss_in_scene(const Diagnostic& finding, const SourceMap& sources) {
  if (finding.severity != Severity::error) return std::nullopt;
  const Rule& rule = *finding.rule;
  switch (input_kind(sources.path(finding.span.source))) {
  case InputKind::resource: return std::nullopt;
  case InputKind::urdf: return loss_in_robot(rule);
  case InputKind::annotation:
    // Of annotations, only the named poses say where a link stands.
    if (rule.id.starts_with("SML0")) return "a file cannot be read";
    if (section_of(finding) == "poses") return "a named pose is not understood";
    return std::nullopt;
  case InputKind::model: return "a .smurf decides which files a robot is made of";
  case InputKind::scene:
  case InputKind::drawing:
  case InputKind::other: break;
  }
  return "it is not known where everything stands";
}

}  // namespace smurf::tools
