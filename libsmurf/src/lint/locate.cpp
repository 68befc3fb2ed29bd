// SPDX-License-Identifier: BSD-3-Clause
// From byte spans back to YAML pointers and XPaths: rules report places, people and programs want
// names of places too.
#include <algorithm>

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

/// MuJoCo discards visuals, unless the file says otherwise.
bool keeps_visuals(const xml::Document& document) {
  if (document.root == xml::kNoElement) return false;
  const xml::View mujoco = xml::View(document, document.root).child("mujoco");
  const xml::View compiler = mujoco ? mujoco.child("compiler") : xml::View();
  const xml::Attribute* discards = compiler ? compiler.attribute("discardvisual") : nullptr;
  return discards != nullptr && discards->value() == "false";
}

void mark_visuals(const xml::Document& document, std::span<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.span.source != document.source) continue;
    const bool is_marked = diagnostic.construct.find(kVisualsKept) != std::string::npos;
    if (is_marked || diagnostic.pointer.find("/visual") == std::string::npos) continue;
    diagnostic.construct += kVisualsKept;
  }
}

constexpr std::string_view kDrakeIgnored = "#drake-ignored";

/// Drake does not read links and joints that are marked so.
void mark_ignored(const xml::Document& document, std::span<Diagnostic> diagnostics) {
  std::vector<Span> ignored;  // in the order of the file
  for (const xml::View element : document.view()) {
    const xml::Attribute* mark = element.attribute("drake_ignore");
    if (mark != nullptr && mark->value() == "true") ignored.push_back(element.span());
  }
  if (ignored.empty()) return;
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.span.source != document.source) continue;
    const auto behind = std::ranges::upper_bound(ignored, diagnostic.span.begin, {}, &Span::begin);
    if (behind == ignored.begin() || diagnostic.span.begin >= std::prev(behind)->end) continue;
    if (diagnostic.construct.find(kDrakeIgnored) == std::string::npos) {
      diagnostic.construct += kDrakeIgnored;
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
  if (model.robot && keeps_visuals(model.robot->document)) {
    mark_visuals(model.robot->document, diagnostics);
  }
  if (model.robot) mark_ignored(model.robot->document, diagnostics);
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
