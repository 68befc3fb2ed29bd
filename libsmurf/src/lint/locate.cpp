// SPDX-License-Identifier: BSD-3-Clause
// From byte spans back to YAML pointers and XPaths: rules report places, people and programs want
// names of places too.
#include <algorithm>
#include <iterator>

#include "base/quoted.hpp"
#include "base/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "smurf/lint.hpp"

namespace smurf {
namespace {

std::string pointer_in(const xml::Document& document, xml::XPaths& paths, Span span) {
  const xml::ElementId id = xml::element_at(document, span.begin);
  if (id == xml::kNoElement) return {};
  std::string path = paths.find(id);
  const xml::View element(document, id);
  const auto* attribute = std::find_if(
      element.attributes_begin(), element.attributes_end(), [&](const xml::Attribute& a) {
        return a.span().begin <= span.begin && span.end <= a.span().end;
      });
  if (attribute != element.attributes_end()) {
    constexpr std::size_t kLongestName = 200;
    path += "/@" + shortened(attribute->name(), kLongestName);
  }
  return path;
}

void point(Diagnostic& diagnostic, const yaml::Document& document) {
  const yaml::NodeId id = yaml::node_at(document, diagnostic.span.begin);
  if (id == yaml::kNoNode) return;
  if (diagnostic.pointer.empty()) diagnostic.pointer = yaml::pointer(document, id);
  diagnostic.named_pointer = yaml::named_pointer(document, id);
}

void point(Diagnostic& diagnostic, const xml::Document& document, xml::XPaths& paths) {
  if (diagnostic.pointer.empty()) {
    diagnostic.pointer = pointer_in(document, paths, diagnostic.span);
  }
  diagnostic.named_pointer = diagnostic.pointer;
}

void locate_in(const xml::Document& document, std::span<Diagnostic> diagnostics) {
  xml::XPaths paths(document);
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.named_pointer.empty() || diagnostic.span.source != document.source) continue;
    point(diagnostic, document, paths);
  }
}

void locate_in(const yaml::Document& document, std::span<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.named_pointer.empty() || diagnostic.span.source != document.source) continue;
    point(diagnostic, document);
  }
}

void add_construct(Diagnostic& diagnostic, std::string_view construct) {
  if (diagnostic.construct.find(construct) == std::string::npos) diagnostic.construct += construct;
}

/// Adds to the construct of what is found at such places.
void mark(const xml::Document& document, std::string_view place, std::string_view construct,
          std::span<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.span.source != document.source) continue;
    if (diagnostic.pointer.find(place) != std::string::npos) add_construct(diagnostic, construct);
  }
}

/// The one of links or joints, which are in the order of the file, that holds a place.
template <class Part>
const Part* part_at(const std::vector<Part>& parts, Span place) {
  const auto next = std::upper_bound(
      parts.begin(), parts.end(), place.begin,
      [](std::uint32_t begin, const Part& part) { return begin < part.span.begin; });
  if (next == parts.begin()) return nullptr;
  const Part& part = *std::prev(next);
  return place.begin < part.span.end ? &part : nullptr;
}

/// Does nothing but what the link is fixed to make it move, or nothing at all?
bool is_carried(const LinkedModel& model, const urdf::Link& link) {
  const auto index = static_cast<std::size_t>(&link - model.robot->links.data());
  const auto above = model.tree.parent_joint[index];
  return !above || model.joint(*above).type == urdf::JointType::fixed;
}

/// What readers make of inertials depends on what moves, and of the parts of a joint on its type:
/// "#in-fixed/limit/@lower/".
void mark_motion(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.span.source != model.robot->document.source) continue;
    constexpr std::string_view kJoint = "/robot/joint/";
    const std::string path = fact_path(diagnostic);
    if (path.starts_with("/robot/link/inertial/")) {
      const urdf::Link* link = part_at(model.robot->links, diagnostic.span);
      if (link != nullptr && is_carried(model, *link)) add_construct(diagnostic, "#carried");
    } else if (path.starts_with(kJoint) && path.find("#in-") == std::string::npos) {
      const urdf::Joint* joint = part_at(model.robot->joints, diagnostic.span);
      if (joint == nullptr || joint->type == urdf::JointType::unknown) continue;
      const std::size_t end = std::min(path.find('#'), path.size());
      add_construct(diagnostic, "#in-" + *joint->type_name + "/" +
                                    path.substr(kJoint.size(), end - kJoint.size()));
    }
  }
}

}  // namespace

void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  std::optional<xml::XPaths> paths;
  if (model.robot) paths.emplace(model.robot->document);
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.named_pointer.empty()) continue;
    const SourceId source = diagnostic.span.source;
    if (const yaml::Document* document = model.document(source)) {
      point(diagnostic, *document);
    } else if (model.robot && model.robot->document.source == source) {
      point(diagnostic, model.robot->document, *paths);
    }
  }
  if (!model.robot) return;
  mark_motion(model, diagnostics);
  if (balances_inertias(model)) {
    mark(model.robot->document, "/inertia", kBalanced, diagnostics);
  }
  if (keeps_visuals(model)) mark(model.robot->document, "/visual", kVisualsKept, diagnostics);
  if (is_told_where_meshes_are(model)) {
    mark(model.robot->document, "/mesh/@filename", kElsewhere, diagnostics);
  }
}

void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics) {
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      locate_in(*file.drawing, diagnostics);
    } else if (file.document) {
      locate_in(*file.document, diagnostics);
    }
  }
  for (const DataFile& file : scene.data_files) locate_in(file.document, diagnostics);
  for (const LinkedModel& model : scene.models) locate(model, diagnostics);
}

}  // namespace smurf
