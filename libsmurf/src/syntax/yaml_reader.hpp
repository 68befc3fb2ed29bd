// SPDX-License-Identifier: BSD-3-Clause
// Source -> yaml::Document. This is the only place that uses yaml-cpp.
#pragma once

#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Reports SML00xx and returns the tree of the first document; none if the text is not YAML. An
/// empty file gives a document without a root.
std::optional<yaml::Document> parse_yaml(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink);

/// yaml-cpp defines what YAML is. The scanner of plain_yaml.hpp reads a subset with the same
/// result, but faster; parse_yaml() tries it first.
enum class YamlEngine : bool { scanner_first, yaml_cpp };
std::optional<yaml::Document> parse_yaml_by(YamlEngine engine, const SourceMap& sources,
                                            SourceId id, const Limits& limits,
                                            DiagnosticSink& sink);

}  // namespace smurf
