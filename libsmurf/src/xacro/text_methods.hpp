// SPDX-License-Identifier: BSD-3-Clause
// What methods of texts have in common.
#pragma once

#include <string>
#include <string_view>

#include "xacro/evaluator.hpp"

namespace smurf::xacro {

inline const std::string& self_of(const Call& call) { return *call.self.text; }
/// The parameter as a text; null, with a failure, if it is something else.
const std::string* text_at(Call& call, std::size_t position);
bool is_ascii(std::string_view text);
bool is_letter(char c);

// The methods that search in a text are in text_queries.cpp.
/// startswith() and endswith().
Value has_end(Call& call);
/// find(), rfind(), index(), rindex().
Value find_text(Call& call);
Value count_text(Call& call);
/// isdigit(), isalpha() and their kind, for ASCII.
Value is_class(Call& call);

}  // namespace smurf::xacro
