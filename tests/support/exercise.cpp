// SPDX-License-Identifier: BSD-3-Clause
#include "support/exercise.hpp"

#include "check/xacro_places.hpp"
#include "smurf/convert.hpp"
#include "smurf/fix.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "smurf/render.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::test {
namespace {

constexpr std::size_t kRendered = 500;

void render_all(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                Exercise& result) {
  for (std::size_t i = 0; i < std::min(diagnostics.size(), kRendered); ++i) {
    if (render_full(diagnostics[i], sources, {}).empty())
      result.broken.push_back("an empty report");
  }
  if (render_json(diagnostics, sources, summarize(diagnostics), {"test", "0"}).empty()) {
    result.broken.push_back("an empty JSON report");
  }
}

/// urdfdom must accept the files that we accept and export.
void convert(const LinkedModel& model, const SourceMap& sources, Exercise& result) {
  DiagnosticSink sink;
  const std::string urdf = export_urdf(model, sources, {}, sink);
  const RefereeVerdict verdict = ask_urdfdom(urdf);
  if (verdict.was_asked && !verdict.accepts) {
    result.broken.push_back("urdfdom refuses an accepted model: " + verdict.messages);
  }
}

void write(const LinkedScene& scene, const SourceMap& sources) {
  const FlatScene flat = flatten(scene, sources, {});
  DiagnosticSink losses;
  for (const SceneFormat* format : scene_formats()) {
    format->write({flat, scene, sources, losses, true,
                   format->has_expanded_form ? SceneForm::expand : SceneForm::reference});
  }
}

}  // namespace

void check_findings(const std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                    Exercise& result) {
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string id(diagnostic.rule->id);
    if (diagnostic.span.end > sources.text(diagnostic.span.source).size()) {
      result.broken.push_back(id + ": a span beyond the end of the file");
    }
    if (diagnostic.span.begin > diagnostic.span.end)
      result.broken.push_back(id + ": a negative span");
    if (diagnostic.message.empty()) result.broken.push_back(id + ": no message");
    result.has_errors |= diagnostic.severity == Severity::error;
    if (id.starts_with("SML00") && diagnostic.severity == Severity::error) {
      result.unreadable.emplace(sources.path(diagnostic.span.source));
    }
  }
}

Exercise exercise(const FileReader& files, const std::string& path,
                  const ExerciseOptions& options) {
  Exercise result;
  SourceMap sources;
  DiagnosticSink sink;
  MeshLibrary meshes;
  LoadContext context{sources, files, sink, {}, {}, {}, &meshes};
  std::vector<Diagnostic> diagnostics;
  const auto judge = [&](const auto& loaded) {
    diagnostics = sink.take();
    locate(loaded, diagnostics);
    place_in_xacro(*context.expansions, sources, diagnostics);
    diagnostics = apply_selection(std::move(diagnostics), sources, {});
    check_findings(diagnostics, sources, result);
  };
  if (path.ends_with(".smurfs")) {
    const LinkedScene scene = load_scene(path, context);
    lint_scene(scene, {}, sink);
    for (const LinkedModel& model : scene.models) lint_model(model, {}, sink);
    judge(scene);
    if (options.converts && !result.has_errors) write(scene, sources);
  } else {
    const LinkedModel model = load_model(path, context);
    lint_model(model, {}, sink);
    judge(model);
    if (options.converts && !result.has_errors && model.robot) convert(model, sources, result);
  }
  result.findings = diagnostics.size();
  if (options.renders && result.broken.empty()) render_all(diagnostics, sources, result);
  if (options.fixes) {
    for (FixedText& text : apply_fixes(diagnostics, sources, Applicability::unsafe).texts) {
      result.fixed.emplace_back(std::move(text.path), std::move(text.text));
    }
  }
  return result;
}

}  // namespace smurf::test
