// SPDX-License-Identifier: BSD-3-Clause
// Values of the wrong kind (SML4001), with what was expected and found: readers treat a list in
// place of a number, a text there, and a text in place of a mapping differently.
#pragma once

#include <string>
#include <string_view>

#include "ast/keys.hpp"

namespace smurf {

/// What is wanted; the names are in the facts of SML4001, such as "#names-text".
namespace wanted {
inline constexpr std::string_view kValue = "value";      ///< a text, a number, true or false
inline constexpr std::string_view kNames = "names";      ///< a list of names
inline constexpr std::string_view kNumbers = "numbers";  ///< a list of numbers
inline constexpr std::string_view kMapping = "mapping";
inline constexpr std::string_view kSection = "section";
inline constexpr std::string_view kEntry = "entry";    ///< an entry of a section
inline constexpr std::string_view kEntity = "entity";  ///< an entity of a scene
}  // namespace wanted

/// Reports `message` at the value, whose construct says what is wanted and what is there.
Diagnostic& report_wrong_type(std::string_view wanted, yaml::View value, std::string message,
                              DiagnosticSink& sink);

}  // namespace smurf
