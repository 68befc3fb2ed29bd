// SPDX-License-Identifier: BSD-3-Clause
// Finds the YAML pointer or XPath of a byte span: rules report spans, users and programs also need
// names of places.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/findings/cases.hpp"
#include "base/findings/place_names.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "smurf/companions.hpp"
#include "smurf/lint.hpp"
#include "smurf/readers.hpp"

namespace smurf {
namespace {

/// The names of an element and of those around it, from the root down.
std::vector<PlaceName> names_of(const xml::Document& document, xml::ElementId id) {
  std::vector<PlaceName> names;
  while (id != xml::kNoElement) {
    const xml::View element(document, id);
    names.push_back(place_name(element.name()));
    id = element.element().parent;
  }
  std::reverse(names.begin(), names.end());
  return names;
}

void point(Diagnostic& diagnostic, const yaml::Document& document) {
  const yaml::NodeId id = yaml::node_at(document, diagnostic.span.begin);
  if (id == yaml::kNoNode) return;
  if (diagnostic.pointer.empty()) diagnostic.pointer = yaml::pointer(document, id);
  diagnostic.named_pointer = yaml::named_pointer(document, id);
  diagnostic.names = place_of(diagnostic);
}

void point(Diagnostic& diagnostic, const xml::Document& document, xml::XPaths& paths) {
  const Span span = diagnostic.span;
  const xml::ElementId id = xml::element_at(document, span.begin);
  const bool is_placed = diagnostic.pointer.empty() && id != xml::kNoElement;
  if (is_placed) {
    diagnostic.pointer = paths.find(id);
    diagnostic.names = names_of(document, id);
    for (const xml::Attribute& attribute : xml::View(document, id).attributes()) {
      if (span.begin < attribute.span().begin || attribute.span().end < span.end) continue;
      constexpr std::size_t kLongestName = 200;
      diagnostic.pointer += "/@" + shortened(attribute.name(), kLongestName);
      diagnostic.names.push_back(place_name("@" + std::string(attribute.name())));
      break;
    }
  }
  // An element whose name is in another case is at the place of the one that is meant.
  const bool is_read = !is_placed || diagnostic.rule == &rules::sml1114_tag_case;
  if (is_read) {
    diagnostic.names.clear();
    diagnostic.names = place_of(diagnostic);
  }
  diagnostic.named_pointer = diagnostic.pointer;
}

/// Findings without a location, by their source: a scene may have thousands of both.
class BySource {
 public:
  explicit BySource(std::span<Diagnostic> diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.named_pointer.empty()) found_[diagnostic.span.source].push_back(&diagnostic);
    }
  }

  /// Only once, because models may share a file.
  std::vector<Diagnostic*> take(SourceId source) {
    const auto found = found_.extract(source);
    return found ? std::move(found.mapped()) : std::vector<Diagnostic*>();
  }

 private:
  std::unordered_map<SourceId, std::vector<Diagnostic*>> found_;
};

/// A fault of YAML matters more in the file that lists the others, even if it has no tree.
void locate_in(const std::optional<yaml::Document>& document, SourceId source,
               const Circumstance& kind, BySource& found) {
  for (Diagnostic* diagnostic : found.take(source)) {
    if (document) point(*diagnostic, *document);
    const std::string_view id = diagnostic->rule->id;
    if (!id.starts_with("SML00") && id != "SML2011") continue;
    diagnostic->when(kind);
  }
}

std::vector<Diagnostic*> locate_in(const xml::Document& document, BySource& all) {
  xml::XPaths paths(document);
  std::vector<Diagnostic*> found = all.take(document.source);
  for (Diagnostic* diagnostic : found) point(*diagnostic, document, paths);
  return found;
}

void locate_in(const LinkedModel& model, BySource& all) {
  for (const ModelFile& file : model.files) {
    if (file.kind == ModelFile::Kind::urdf) continue;
    locate_in(file.document, file.source,
              file.kind == ModelFile::Kind::main ? cases::kInMain : cases::kInAnnotations, all);
  }
  if (!model.robot) return;
  const std::vector<Diagnostic*> found = locate_in(model.robot->document, all);
  if (found.empty()) return;
  for (const Reader* reader : all_readers()) {
    if (reader->see != nullptr) reader->see(model, found);
  }
}

}  // namespace

void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  locate_in(model, found);
}

void locate(const Companions& companions, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  for (const Companion& one : companions.files) {
    if (one.srdf) locate_in(one.srdf->document, found);
    if (one.document) locate_in(one.document, one.source, cases::kInCompanion, found);
  }
}

void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  // A robot that is given as a scene has one file for both, which the scene has not read.
  for (const LinkedModel& model : scene.models) locate_in(model, found);
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      locate_in(*file.drawing, found);
    } else {
      locate_in(file.document, file.source, cases::kInScene, found);
    }
  }
  for (const DataFile& file : scene.data_files) {
    for (Diagnostic* diagnostic : found.take(file.document.source)) {
      point(*diagnostic, file.document);
    }
  }
}

}  // namespace smurf
