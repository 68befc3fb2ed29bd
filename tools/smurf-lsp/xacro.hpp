// SPDX-License-Identifier: BSD-3-Clause
// The names of xacro: macros, parameters, properties and arguments, and the files that define them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf-lsp/context.hpp"

namespace smurf::lsp {

/// A part of a file.
struct XacroPlace {
  const XacroFamily::File* file = nullptr;
  tools::TextRange range;
};

/// A name and its definitions.
struct XacroMeaning {
  tools::XacroNameKind kind{};
  std::string name;
  tools::TextRange at;  ///< in the document
  struct Definition {
    const XacroFamily::File* file = nullptr;
    const tools::XacroName* name = nullptr;
  };
  std::vector<Definition> definitions;
};

/// The definitions of a name; of a parameter, those of the macro.
std::vector<XacroMeaning::Definition> xacro_definitions(const XacroFamily& family,
                                                        tools::XacroNameKind kind,
                                                        std::string_view name,
                                                        std::string_view macro = {});
/// The macro around a place of a file; null if there is none.
const tools::XacroTag* xacro_macro_around(const XacroFamily::File& file, std::string_view text,
                                          std::size_t offset);
/// What the name at a place of the document means; none if there is no name of xacro.
std::optional<XacroMeaning> xacro_meaning(const XacroFamily& family, std::size_t offset);
/// All places of a name, with its definitions.
std::vector<XacroPlace> xacro_places(const XacroFamily& family, const XacroMeaning& meaning);

Json to_json(const XacroFamily& family, const XacroPlace& place, const Context& context);

/// The document of a request as a xacro, and the place in it.
struct XacroRequest {
  std::string path;
  const XacroFamily* family = nullptr;
  std::size_t offset = 0;

  const XacroFamily::File& own() const { return family->files.front(); }
  std::string_view text() const { return family->text(own()); }
};
std::optional<XacroRequest> xacro_request(Context& context, const Json& params);

}  // namespace smurf::lsp
