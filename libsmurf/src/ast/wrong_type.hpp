// SPDX-License-Identifier: BSD-3-Clause
// Values of the wrong kind (SML4001), with the expected and the found kind: readers treat, for
// example, a list and a text in place of a number differently.
#pragma once

#include <string>
#include <string_view>

#include "ast/keys.hpp"

namespace smurf {

/// The expected type; its name is in the facts of SML4001, such as "#names-text".
namespace wanted {
inline constexpr std::string_view kValue = "value";      ///< a text, a number, true or false
inline constexpr std::string_view kNames = "names";      ///< a list of names
inline constexpr std::string_view kNumbers = "numbers";  ///< a list of numbers
inline constexpr std::string_view kMapping = "mapping";
inline constexpr std::string_view kSection = "section";
inline constexpr std::string_view kEntry = "entry";    ///< an entry of a section
inline constexpr std::string_view kEntity = "entity";  ///< an entity of a scene
}  // namespace wanted

/// Reports `message` at the value. Its construct names the expected and the actual type.
Diagnostic& report_wrong_type(std::string_view wanted, yaml::View value, std::string message,
                              DiagnosticSink& sink);

}  // namespace smurf
