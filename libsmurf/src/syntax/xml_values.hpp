// SPDX-License-Identifier: BSD-3-Clause
// Values of XML elements.
#pragma once

#include <string_view>

#include "smurf/xml.hpp"

namespace smurf {

/// The value of an attribute; "" without it, or without an element.
inline std::string_view attribute_of(xml::View element, std::string_view name) {
  const xml::Attribute* attribute = element ? element.attribute(name) : nullptr;
  return attribute != nullptr ? attribute->value() : std::string_view();
}

}  // namespace smurf
