// SPDX-License-Identifier: BSD-3-Clause
// The export edits bytes; it never prints a tree unless asked for the canonical form (urdfdom's own
// export loses names, extensions, comments and digits). Each step parses the output of the previous
// step, so the steps are independent.
#include <functional>
#include <memory>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "convert/passes.hpp"
#include "convert/rebase.hpp"
#include "smurf/load.hpp"
#include "syntax/strict_xml.hpp"

namespace smurf {
namespace {

/// The text between two steps, and its model.
class Stepper {
 public:
  Stepper(const LinkedModel& model, std::string_view text) : model_(&model), text_(text) {}

  const LinkedModel& model() const { return *model_; }
  const std::string& text() const { return text_; }
  bool is_sound() const { return model_->robot.has_value(); }

  void edit(const std::function<void(XmlEdits&)>& step) {
    if (!is_sound()) return;
    XmlEdits edits(model_->robot->document, text_);
    step(edits);
    if (!edits.empty()) take(edits.apply());
  }

  void take(std::string text) {
    text_ = std::move(text);
    read_ = std::make_unique<Read>();
    read_->files.add("step.urdf", text_);
    LoadContext context{read_->sources, read_->files, read_->sink, {}, {}};
    read_->model = load_model("step.urdf", context);
    model_ = &read_->model;
  }

 private:
  struct Read {
    SourceMap sources;
    MemoryFiles files;
    DiagnosticSink sink;
    LinkedModel model;
  };

  const LinkedModel* model_;
  std::string text_;
  std::unique_ptr<Read> read_;
};

void report(const std::vector<passes::CollapsedLink>& collapsed, const LinkedModel& model,
            DiagnosticSink& sink) {
  for (const auto& [name, carrier] : collapsed) {
    if (const auto index = model.link_names.find(name)) {
      sink.report(rules::sml8005_collapsed_link, model.robot->links[*index].name.span,
                  "the link `" + name + "` becomes part of `" + carrier + "`");
    }
  }
}

}  // namespace

std::vector<Edit> rebase_paths(const LinkedModel& model, const std::string& folder,
                               const std::string& current_folder,
                               const std::map<std::string, std::string>& copies) {
  std::vector<Edit> edits;
  for (const MeshReference& mesh : model.meshes) {
    if (const auto copy = copies.find(mesh.path); copy != copies.end()) {
      edits.push_back({mesh.span, escape_xml(path::relative(copy->second, folder))});
      continue;
    }
    const bool is_uri = mesh.filename.find("://") != std::string_view::npos;
    const bool is_relative = !mesh.filename.empty() && !path::is_absolute(mesh.filename);
    // MARS does not open URIs, and Phobos looks for packages in only one folder.
    if (is_uri ? mesh.path.empty() || !mesh.exists : !is_relative) continue;
    const std::string target = places::absolute_from(current_folder, mesh.path);
    if (!is_uri && path::join(folder, mesh.filename) == target) continue;  // resolves as written
    edits.push_back({mesh.span, escape_xml(path::relative(target, folder))});
  }
  return edits;
}

std::string export_urdf(const LinkedModel& model, const SourceMap& sources,
                        const UrdfExport& options, DiagnosticSink& sink) {
  Stepper steps(model, sources.text(model.robot->document.source));
  // Both need the annotations and files around the URDF, so they are applied first.
  steps.edit([&](XmlEdits& edits) {
    passes::apply_annotations(model, options, sink, edits);
    passes::rewrite_paths(model, options, edits);
    if (options.actuation != Actuation::none) {
      passes::add_actuation(model, options.actuation, edits);
    }
    if (options.adds_gazebo_sensors) passes::add_gazebo_sensors(model, edits);
  });
  if (options.actuation == Actuation::ros2_control) {
    steps.edit([&](XmlEdits& edits) {
      for (const xml::View element :
           passes::replaced_transmissions(steps.model(), options.actuation)) {
        edits.remove(element);
      }
    });
  }
  if (options.strips_extensions) {
    steps.edit([&](XmlEdits& edits) { passes::strip_extensions(steps.model(), edits); });
  }
  if (options.adds_mujoco_settings) {
    const bool has_new_paths = options.mesh_uri == MeshUri::relative;
    steps.edit(
        [&](XmlEdits& edits) { passes::add_mujoco_settings(steps.model(), has_new_paths, edits); });
  }
  if (options.strips_comments) {
    steps.edit([&](XmlEdits& edits) { passes::strip_comments(steps.model(), edits); });
  }
  if (options.collapses_fixed) {
    std::vector<passes::CollapsedLink> collapsed;
    steps.edit([&](XmlEdits& edits) {
      collapsed = passes::collapse_fixed(steps.model(), options.keep, edits);
    });
    report(collapsed, model, sink);
  }
  if (!options.prefix.empty()) {
    steps.edit([&](XmlEdits& edits) { passes::add_prefix(steps.model(), options.prefix, edits); });
  }
  if (options.base != BaseJoint::as_is) {
    steps.edit([&](XmlEdits& edits) { passes::add_base(steps.model(), options.base, edits); });
  }
  if (!options.version.empty()) {
    steps.edit(
        [&](XmlEdits& edits) { passes::set_version(steps.model(), options.version, edits); });
  }
  steps.edit([&](XmlEdits& edits) { passes::rename_contacts(model, steps.model(), edits); });
  if (options.is_canonical && steps.is_sound()) {
    steps.take(canonical_urdf(steps.model(), steps.text()));
  }
  return strict_xml_file(steps.text());
}

std::string why_strict_readers_refuse(const LinkedModel& result, std::string_view urdf) {
  return why_strict_readers_refuse(result.robot->document, urdf);
}

}  // namespace smurf
