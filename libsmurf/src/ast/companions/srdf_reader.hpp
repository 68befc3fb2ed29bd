// SPDX-License-Identifier: BSD-3-Clause
// xml::Document -> srdf::Description.
#pragma once

#include <span>
#include <string_view>

#include "smurf/srdf.hpp"

namespace smurf::srdf {

/// Reads what srdfdom reads. Absent and misspelt parts stay absent; rules report them.
Description read(xml::Document&& document);

/// An element of an SRDF, the attributes that srdfdom needs, and those that it reads if present.
struct ElementSpec {
  std::string_view parent, name;
  std::span<const std::string_view> required;
  std::span<const std::string_view> optional = {};
};
std::span<const ElementSpec> all_element_specs();
/// Null for an element that srdfdom does not read there.
const ElementSpec* find_element_spec(std::string_view parent, std::string_view name);

}  // namespace smurf::srdf
