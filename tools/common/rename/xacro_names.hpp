// SPDX-License-Identifier: BSD-3-Clause
// The names of xacro: macros, parameters, properties and arguments, and the files that define them.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plan/xacro_text.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {

/// A file, the files that include it, and all files that these include.
struct XacroFamily {
  struct File {
    SourceId source{};
    XacroText read;
  };
  SourceMap sources;
  std::deque<File> files;  ///< the first is the document of an editor

  std::string_view text(const File& file) const { return sources.text(file.source); }
  void add(const std::string& path, std::string content) {
    const SourceId source = sources.add(path, std::move(content));
    files.push_back({source, read_xacro_text(sources.text(source))});
  }
};

/// A part of a file.
struct XacroPlace {
  const XacroFamily::File* file = nullptr;
  TextRange range;
};

/// A name and its definitions.
struct XacroMeaning {
  XacroNameKind kind{};
  std::string name;
  TextRange at;  ///< in the document
  struct Definition {
    const XacroFamily::File* file = nullptr;
    const XacroName* name = nullptr;
  };
  std::vector<Definition> definitions;
};

/// The definitions of a name; of a parameter, those of the macro.
std::vector<XacroMeaning::Definition> xacro_definitions(const XacroFamily& family,
                                                        XacroNameKind kind, std::string_view name,
                                                        std::string_view macro = {});
/// The macro around a place of a file; null if there is none.
const XacroTag* xacro_macro_around(const XacroFamily::File& file, std::string_view text,
                                   std::size_t offset);
/// The same for many places in the order of the file, in one walk.
class MacrosAround {
 public:
  MacrosAround(const XacroFamily::File& file, std::string_view text) : file_(file), text_(text) {}
  const XacroTag* at(std::size_t offset);

 private:
  const XacroFamily::File& file_;
  std::string_view text_;
  std::size_t next_ = 0;               ///< tag
  std::vector<const XacroTag*> open_;  ///< macros, the innermost last
};
/// What the name at a place of the first file means; none if there is no name of xacro.
std::optional<XacroMeaning> xacro_meaning(const XacroFamily& family, std::size_t offset);
/// The macro of a parameter; "" for a definition of another kind.
std::string_view macro_of(const XacroFamily& family, const XacroMeaning::Definition& definition);
/// The names in the end tags of the calls of a macro.
std::vector<XacroPlace> xacro_end_tags(const XacroFamily& family, std::string_view macro);
/// All places of a name, with its definitions.
std::vector<XacroPlace> xacro_places(const XacroFamily& family, const XacroMeaning& meaning);

}  // namespace smurf::tools
