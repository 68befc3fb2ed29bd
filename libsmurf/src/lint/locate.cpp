// SPDX-License-Identifier: BSD-3-Clause
// From byte spans back to YAML pointers and XPaths: rules report places, people and programs want
// names of places too.
#include <algorithm>

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
        return a.span.begin <= span.begin && span.end <= a.span.end;
      });
  if (attribute != element.attributes_end()) path += "/@" + std::string(attribute->name);
  return path;
}

/// Empty when the span is in none of the model's trees.
std::string pointer_in(const LinkedModel& model, std::optional<xml::XPaths>& paths, Span span) {
  if (const yaml::Document* document = model.document(span.source)) {
    const yaml::NodeId id = yaml::node_at(*document, span.begin);
    return id == yaml::kNoNode ? std::string() : yaml::pointer(*document, id);
  }
  if (model.robot && model.robot->document.source == span.source) {
    return pointer_in(model.robot->document, *paths, span);
  }
  return {};
}

void locate_in(const yaml::Document& document, std::span<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.pointer.empty() || diagnostic.span.source != document.source) continue;
    const yaml::NodeId id = yaml::node_at(document, diagnostic.span.begin);
    if (id != yaml::kNoNode) diagnostic.pointer = yaml::pointer(document, id);
  }
}

}  // namespace

void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  std::optional<xml::XPaths> paths;
  if (model.robot) paths.emplace(model.robot->document);
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.pointer.empty()) diagnostic.pointer = pointer_in(model, paths, diagnostic.span);
  }
}

void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics) {
  for (const SceneFile& file : scene.scenes) {
    if (file.document) locate_in(*file.document, diagnostics);
  }
  for (const DataFile& file : scene.data_files) locate_in(file.document, diagnostics);
  for (const LinkedModel& model : scene.models) locate(model, diagnostics);
}

}  // namespace smurf
