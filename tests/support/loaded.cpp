// SPDX-License-Identifier: BSD-3-Clause
#include "support/loaded.hpp"

namespace smurf::test {

std::string brief(const Diagnostic& diagnostic, const SourceMap& sources) {
  const Position at = sources.position(diagnostic.span.source, diagnostic.span.begin);
  return std::string(diagnostic.rule->id) + " " + sources.path(diagnostic.span.source) + ":" +
         std::to_string(at.line) + ":" + std::to_string(at.column);
}

void Loaded::load(const std::string& path) {
  LoadContext context{sources, files, sink, {}, {}, {}, &meshes};
  model = load_model(path, context);
  lint_model(model, {}, sink);
  diagnostics = sink.take();
  locate(model, diagnostics);
  diagnostics = apply_selection(std::move(diagnostics), sources, {});
}

std::vector<std::string> Loaded::briefs() const {
  std::vector<std::string> all;
  for (const Diagnostic& diagnostic : diagnostics) all.push_back(brief(diagnostic, sources));
  return all;
}

std::vector<std::string> lint_urdf(const std::string& text) {
  Loaded loaded;
  loaded.files.add("robot.urdf", text);
  loaded.load("robot.urdf");
  return loaded.briefs();
}

}  // namespace smurf::test
