// SPDX-License-Identifier: BSD-3-Clause
// From byte spans back to YAML pointers and XPaths: rules report places, people and programs want
// names of places too.
#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/quoted.hpp"
#include "base/readers.hpp"
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

/// Findings that were not located yet, by their source: a scene may have thousands of both.
class BySource {
 public:
  explicit BySource(std::span<Diagnostic> diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.named_pointer.empty()) found_[diagnostic.span.source].push_back(&diagnostic);
    }
  }

  std::span<Diagnostic* const> of(SourceId source) const {
    const auto found = found_.find(source);
    if (found == found_.end()) return {};
    return found->second;
  }

 private:
  std::unordered_map<SourceId, std::vector<Diagnostic*>> found_;
};

void locate_in(const yaml::Document& document, const BySource& found) {
  for (Diagnostic* diagnostic : found.of(document.source)) point(*diagnostic, document);
}

void locate_in(const xml::Document& document, const BySource& found) {
  xml::XPaths paths(document);
  for (Diagnostic* diagnostic : found.of(document.source)) point(*diagnostic, document, paths);
}

/// MuJoCo discards visuals, unless the file says otherwise.
bool keeps_visuals(const xml::Document& document) {
  if (document.root == xml::kNoElement) return false;
  const xml::View mujoco = xml::View(document, document.root).child("mujoco");
  const xml::View compiler = mujoco ? mujoco.child("compiler") : xml::View();
  const xml::Attribute* discards = compiler ? compiler.attribute("discardvisual") : nullptr;
  return discards != nullptr && discards->value() == "false";
}

/// MuJoCo loads what is in visuals.
void mark_visuals(const xml::Document& document, std::span<Diagnostic* const> found) {
  if (!keeps_visuals(document)) return;
  for (Diagnostic* diagnostic : found) {
    const bool is_in_visual = diagnostic->pointer.find("/visual") != std::string::npos;
    if (is_in_visual) diagnostic->construct += kVisualsKept;
  }
}

constexpr std::string_view kDrakeIgnored = "#drake-ignored";

/// Drake does not read links and joints that are marked so.
void mark_ignored(const xml::Document& document, std::span<Diagnostic* const> found) {
  std::vector<Span> ignored;  // in the order of the file
  for (const xml::View element : document.view()) {
    const xml::Attribute* mark = element.attribute("drake_ignore");
    if (mark != nullptr && mark->value() == "true") ignored.push_back(element.span());
  }
  if (ignored.empty()) return;
  for (Diagnostic* diagnostic : found) {
    const std::uint32_t begin = diagnostic->span.begin;
    const auto behind = std::ranges::upper_bound(ignored, begin, {}, &Span::begin);
    if (behind == ignored.begin() || begin >= std::prev(behind)->end) continue;
    diagnostic->construct += kDrakeIgnored;
  }
}

void locate_in(const urdf::Robot& robot, const BySource& all) {
  locate_in(robot.document, all);
  const std::span<Diagnostic* const> found = all.of(robot.document.source);
  mark_visuals(robot.document, found);
  mark_ignored(robot.document, found);
}

void locate_in(const LinkedModel& model, const BySource& found) {
  for (const ModelFile& file : model.files) {
    if (file.document) locate_in(*file.document, found);
  }
  if (model.robot) locate_in(*model.robot, found);
}

}  // namespace

void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  locate_in(model, BySource(diagnostics));
}

void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics) {
  const BySource found(diagnostics);
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      locate_in(*file.drawing, found);
    } else if (file.document) {
      locate_in(*file.document, found);
    }
  }
  for (const DataFile& file : scene.data_files) locate_in(file.document, found);
  for (const LinkedModel& model : scene.models) locate_in(model, found);
}

}  // namespace smurf
