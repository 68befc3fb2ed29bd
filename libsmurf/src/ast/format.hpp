// SPDX-License-Identifier: BSD-3-Clause
// Describes the SMURF format: every section and key with its type, unit and default. Generated from
// the tables that the readers use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// One key of a mapping.
struct KeyDescription {
  std::string path;           ///< "maxSpeed", "ode.stepsize", "loop_constraints[].cut_joint"
  std::string type;           ///< "number, at least 0"
  std::string_view unit;      ///< "rad/s"; may be empty
  std::string_view fallback;  ///< the default of MARS as JSON; may be empty
  std::string_view read_by;   ///< empty: the readers of the whole part
  std::string_view doc;       ///< one sentence
  bool is_required = false;
};

/// A section of annotations, or another mapping with a table of keys.
struct FormatPart {
  std::string_view name;  ///< "motors"
  std::vector<std::string_view> aliases{};
  std::string_view doc;
  std::string_view form{};     ///< "a list of entries"
  std::string_view read_by{};  ///< may be empty
  std::string_view more{};  ///< name of the part whose keys an entry may have as well; may be empty
  std::vector<KeyDescription> keys{};
};

/// The main file, the sections of annotations, `node`, which several sections share, the scene and
/// its entities.
std::vector<FormatPart> describe_format();

}  // namespace smurf
