// SPDX-License-Identifier: BSD-3-Clause
// Makes the sections of a SMURF model from a URDF, one function per section.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/convert.hpp"
#include "syntax/xml_values.hpp"

namespace smurf::import {

/// State shared by the functions that make the sections. Collects names for unnamed collisions.
struct Context {
  const LinkedModel& model;
  const SourceMap& sources;
  const UrdfImport& options;
  DiagnosticSink& sink;
  std::vector<Edit> edits{};

  const urdf::Robot& robot() const { return *model.robot; }
  std::string line_of(Span span) const;  ///< "arm.urdf:12"
  /// Reports SML8101: it has no section, `why`.
  void keep_as_text(Span span, const std::string& what, const std::string& why);
};

/// The file of a section, or none if it has no entries.
using Part = std::optional<NewFile>;
Part motors(Context& context);
Part sensors(Context& context);
Part materials(Context& context);
Part joints(Context& context);
Part poses(Context& context);
Part urdf_extensions(Context& context);
Part srdf_extensions(Context& context);
/// The sections that a file of another language than URDF has.
std::vector<NewFile> made_sections(const LinkedModel& model);

/// The path of a texture from the folder of the main file.
std::string texture_path(const UrdfImport& options, std::string_view path);

/// The text of an element, trimmed.
std::string_view text_of(xml::View element);
/// The text of a child; "" if it is absent.
std::string_view child_text(xml::View element, std::string_view child);
/// The robot's children of this name that URDF does not define.
std::vector<xml::View> extensions_of(const Context& context, std::string_view name);

}  // namespace smurf::import
