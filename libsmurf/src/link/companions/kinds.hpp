// SPDX-License-Identifier: BSD-3-Clause
// What a file is, by its content: which kind of companion, and whether it can be read.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "smurf/companions.hpp"
#include "smurf/diagnostic.hpp"

namespace smurf {

enum class CompanionState : std::uint8_t {
  other,  ///< no companion
  readable,
  a_template,  ///< a launch file fills it in: it has markers such as `$(` and is no YAML
  broken,      ///< it is no YAML, but its lines have the keys of a companion
};

struct Recognised {
  const CompanionSpec* spec = nullptr;
  CompanionState state = CompanionState::other;
};

/// Whether a file with this name may be a companion in YAML.
bool may_be_parameters(std::string_view path);
/// Whether a text has markers that a launch file replaces, outside of comments.
bool is_template(std::string_view text);
/// Whether no reader of ROS can read a YAML text, whatever a launch file fills in. `found` has the
/// findings of parsing it.
bool is_broken_yaml(std::string_view text, const std::optional<yaml::Document>& document,
                    const DiagnosticSink& found);
/// Reports a finding of parsing a text in another sink, without its fixes.
Diagnostic& report_of_yaml(const Diagnostic& finding, DiagnosticSink& sink);
/// Reports a finding that makes the text unreadable, and says what this means to ROS.
void report_broken_yaml(const Diagnostic& finding, DiagnosticSink& sink);
/// Parses the text and looks at its keys, whatever the file is called. A text that is not YAML is
/// recognised by the keys at the beginnings of its lines.
Recognised recognise(std::string_view path, std::string_view text);
/// The same for a text that was parsed; `found` has the findings of that.
Recognised recognise(std::string_view path, std::string_view text,
                     const std::optional<yaml::Document>& document, const DiagnosticSink& found);

}  // namespace smurf
