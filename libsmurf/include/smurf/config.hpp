// SPDX-License-Identifier: BSD-3-Clause
// The configuration file of smurf-lint.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/findings.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

inline constexpr std::string_view kConfigName = ".smurf-lint.yaml";

/// The configuration file in the folder `path`, or beside the file `path`, or in the nearest folder
/// above; "" when there is none.
std::string nearest_config(const std::string& path, const FileReader& files);

/// A pattern as in .gitignore, and the folder it is relative to.
struct ConfigPattern {
  Spanned<std::string> text;
  std::string folder;
};

/// The settings for the files of a pattern.
struct ConfigPath {
  ConfigPattern pattern;
  std::vector<Spanned<std::string>> ignore;
  std::map<std::string, Spanned<Severity>> severities;
};

/// A robot of xacro, and the values of its arguments.
struct ConfigXacro {
  Spanned<std::string> file;
  std::vector<std::pair<Spanned<std::string>, std::vector<std::string>>> arguments;
};

/// Companions of a robot, such as its controllers.yaml.
struct ConfigCompanions {
  Spanned<std::string> robot;
  std::vector<Spanned<std::string>> files;
};

/// The settings of a configuration file and of those that it extends; absent settings are empty.
/// Every value knows where it was written. Paths are relative to the folder that the
/// configuration's own path is relative to.
struct Config {
  std::vector<Spanned<std::string>> select, ignore, targets;
  std::map<std::string, Spanned<Severity>> severities;
  std::map<std::string, Spanned<double>> tolerances;
  std::vector<ConfigPath> paths;
  std::vector<ConfigPattern> exclude;
  std::optional<Spanned<bool>> force_exclude;
  std::map<std::string, Spanned<std::string>> packages;  ///< names to folders
  std::map<std::string, Spanned<std::string>> section_schemas, entity_schemas;  ///< to files
  std::vector<Spanned<std::string>> formats;                                    ///< "FORMAT[=FILE]"
  std::optional<Spanned<std::optional<Severity>>> fail_on;                      ///< none: never
  std::optional<Spanned<int>> max_warnings;
  std::optional<Spanned<std::string>> baseline;
  std::vector<ConfigXacro> xacro;
  std::vector<ConfigCompanions> companions;
  UserSchemas schemas;
};

/// All combinations of the values of a robot; `given` overrides them. If there are more than
/// `most`, a few more than that.
std::vector<std::map<std::string, std::string>>
combinations_of(const ConfigXacro& robot, const std::map<std::string, std::string>& given,
                std::size_t most);

/// Who chose a configuration. A configuration that was found beside the files may come from a
/// stranger, so it must not choose output files.
enum class ConfigOrigin : std::uint8_t { found, named };

/// Reads a configuration with the configurations that it extends and its schemas. Reports mistakes
/// at their place (SML90xx) and ignores the wrong settings. `formats` are the allowed names of
/// formats; empty: any.
Config read_config(const std::string& path, SourceMap& sources, const FileReader& files,
                   DiagnosticSink& sink, std::span<const std::string_view> formats = {},
                   ConfigOrigin origin = ConfigOrigin::found);

/// The kinds of values of settings.
enum class SettingType : std::uint8_t {
  files,       ///< a path or a list of them
  rules,       ///< ids, names or prefixes
  targets,     ///< names of readers
  formats,     ///< FORMAT[=FILE]
  patterns,    ///< as in .gitignore
  levels,      ///< a mapping from rules to severities
  tolerances,  ///< a mapping from rules to numbers
  paths,       ///< a mapping from patterns to settings
  folders,     ///< a mapping from names to folders
  schemas,     ///< a mapping from names to files, of sections and entities
  threshold,   ///< error, warning, info or never
  count,
  boolean,
  file,
  xacro,      ///< a list of robots with arguments
  companions  ///< a list of robots with files
};

/// A setting of the configuration.
struct SettingSpec {
  std::string_view name;
  SettingType type;
  std::string_view doc;  ///< one sentence
};
/// All settings, by name; schemas/config.schema.json is made from them.
std::vector<SettingSpec> config_settings();
/// The settings for the files of a pattern.
std::vector<SettingSpec> config_path_settings();

}  // namespace smurf
