// SPDX-License-Identifier: BSD-3-Clause
#include "convert/passes.hpp"

#include <set>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "smurf/references.hpp"

namespace smurf::passes {
namespace {

bool is_urdf_child(std::string_view parent, std::string_view child) {
  if (parent == "robot") return is_one_of(child, {"link", "joint", "material"});
  if (parent == "link") return is_one_of(child, {"inertial", "visual", "collision"});
  return is_one_of(child, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic",
                           "safety_controller", "calibration"});
}

bool is_relative_path(std::string_view filename) {
  return !filename.empty() && !path::is_absolute(filename) &&
         filename.find("://") == std::string_view::npos;
}

}  // namespace

std::vector<xml::View> extension_elements(const urdf::Robot& robot) {
  std::vector<xml::View> found;
  for (const xml::View child : robot.document.view()) {
    if (!is_urdf_child("robot", child.name())) {
      found.push_back(child);
    } else if (child.name() != "material") {
      for (const xml::View inner : child) {
        if (!is_urdf_child(child.name(), inner.name())) found.push_back(inner);
      }
    }
  }
  return found;
}

void strip_comments(const LinkedModel& model, XmlEdits& edits) {
  for (const Span comment : model.robot->document.comments) edits.remove(comment);
}

void strip_extensions(const LinkedModel& model, XmlEdits& edits) {
  for (const xml::View element : extension_elements(*model.robot)) edits.remove(element);
}

void add_prefix(const LinkedModel& model, const std::string& prefix, XmlEdits& edits) {
  const SourceId urdf = model.robot->document.source;
  for (const Reference& one : references_of(model)) {
    const bool has_prefix = one.kind == NameKind::link || one.kind == NameKind::joint ||
                            one.kind == NameKind::material || one.kind == NameKind::group ||
                            one.kind == NameKind::extension;
    // A text that may name things of several kinds, but names none, is not a name.
    const bool is_name = one.is_known() || one.kinds == one.kind;
    const bool is_of_world = one.kind == NameKind::link && is_world(one.name);
    if (one.span.source != urdf || !has_prefix || !is_name || is_of_world) continue;
    edits.replace({urdf, one.span.begin, one.span.begin}, escape_xml(prefix));
  }
}

void add_base(const LinkedModel& model, BaseJoint base, XmlEdits& edits) {
  const urdf::Link& root = model.link(model.tree.roots.front());
  const xml::View robot = model.robot->document.view();
  const std::string type = base == BaseJoint::fixed ? "fixed" : "floating";
  edits.add_child(robot, "<link name=\"world\"/>");
  edits.add_child(robot, "<joint name=\"world_to_" + escape_xml(*root.name) + "\" type=\"" + type +
                             "\">\n  <parent link=\"world\"/>\n  <child link=\"" +
                             escape_xml(*root.name) + "\"/>\n</joint>");
}

void rewrite_paths(const LinkedModel& model, const UrdfExport& options, XmlEdits& edits) {
  const std::string folder = places::absolute_from(options.current_folder, options.output_folder);
  for (const MeshReference& mesh : model.meshes) {
    if (const auto copy = options.mesh_copies.find(mesh.path); copy != options.mesh_copies.end()) {
      edits.replace(mesh.span, escape_xml(copy->second));
      continue;
    }
    if (options.mesh_uri == MeshUri::keep) continue;
    const bool is_relative = is_relative_path(mesh.filename);
    // Paths to missing files are unchanged if they are absolute; relative paths are re-based to the
    // same missing file.
    if (!is_relative && (options.mesh_uri == MeshUri::rebase || !mesh.exists)) continue;
    const std::string target = places::absolute_from(options.current_folder, mesh.path);
    std::string uri = path::relative(target, folder);
    if (options.mesh_uri == MeshUri::absolute) uri = sys::for_others(target);
    if (options.mesh_uri == MeshUri::file) uri = "file://" + target;
    if (options.mesh_uri == MeshUri::package) {
      const std::string inside = path::relative(target, options.package_folder);
      if (inside.starts_with("..")) continue;  // found by meshes_outside_package()
      uri = "package://" + options.package_name + "/" + inside;
    }
    const bool is_right = is_relative && path::join(folder, mesh.filename) == target;
    const bool may_stay =
        options.mesh_uri == MeshUri::rebase || options.mesh_uri == MeshUri::relative;
    if (mesh.filename == uri || (is_right && may_stay)) continue;
    edits.replace(mesh.span, escape_xml(uri));
  }
}

}  // namespace smurf::passes
