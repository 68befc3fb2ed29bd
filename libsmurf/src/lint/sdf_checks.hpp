// SPDX-License-Identifier: BSD-3-Clause
// What sdformat refuses in elements of SDF, each on its own.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "readers/sdf_language.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf::sdf {

/// Called with the place of a fault and what is wrong; returns the finding.
using Report = std::function<Diagnostic&(Span place, std::string message)>;

inline constexpr Circumstance kEmptyInclude{"empty include"};

/// Reports the faults of an element of this kind and of everything in it.
void check_element(xml::View element, std::string_view kind, const Report& report);
/// Only those of its children.
void check_children(xml::View element, std::string_view kind, const Report& report);

/// Reports an element or attribute whose value sdformat cannot read. `wanted`: "a number".
Diagnostic& report_unreadable(Span place, std::string_view name, bool is_empty,
                              std::string_view wanted, const Report& report);
/// Reports an `include`, whose model sdformat looks for.
void check_include(xml::View include, const Report& report);
/// Reports a name that sdformat keeps for itself.
void check_reserved(xml::View element, const Report& report);
/// The place of an element's text, or of its name when it has none.
Span place_of(xml::View element);
/// The place of an attribute's value, or of the element's name when it has no such attribute.
Span place_of(xml::View element, std::string_view attribute);
/// The value of an attribute without white space around it; empty without.
std::string_view value_of(xml::View element, std::string_view attribute);
/// The text of a child without white space around it; empty without.
std::string_view text_of(xml::View element, std::string_view child);

}  // namespace smurf::sdf
