// SPDX-License-Identifier: BSD-3-Clause
// Renames macros, parameters, properties and arguments of xacro files, and proves that the robots
// stay as they are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/rename/xacro_names.hpp"
#include "plan/xacro_files.hpp"
#include "smurf/check.hpp"
#include "smurf/fix.hpp"

namespace smurf::tools {

/// "macro:wheel=tyre"; a parameter is written with its macro: "parameter:wheel.radius=r".
struct XacroRename {
  XacroNameKind kind{};
  std::string macro;  ///< of a parameter
  std::string from, to;
};
/// None if `kind` is no kind of name in xacro.
std::optional<XacroNameKind> find_xacro_name_kind(std::string_view kind);
std::string_view to_string(XacroNameKind kind);

struct RenamedXacro {
  XacroFamily family;                 ///< the files that may have the name
  std::vector<Edit> edits;            ///< in the sources of the family; none if there are problems
  std::vector<FixedText> texts;       ///< which the session reads now, also if there are problems
  std::vector<std::string> problems;  ///< the reason why nothing is changed
  bool is_known = false;              ///< something has the name
};

/// Changes all places of a name in the file at `path` and in the files that belong to the same
/// robots, and expands these robots before and after it: the results must be equal. Files that
/// `changeable` denies are not changed.
RenamedXacro rename_in_xacro(const XacroFiles& files, const std::string& path,
                             const XacroRename& rename, const CheckSettings& settings,
                             Session& session, const FileReader& changeable);

}  // namespace smurf::tools
