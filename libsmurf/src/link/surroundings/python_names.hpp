// SPDX-License-Identifier: BSD-3-Clause
// The names that a Python file binds, its functions, and the arguments of its calls.
#pragma once

#include <span>
#include <vector>

#include "link/surroundings/python_calls.hpp"
#include "link/surroundings/python_tokens.hpp"

namespace smurf::python {

/// Sets the bound and imported names and the functions of `file`. A name that is bound anywhere
/// counts as bound everywhere.
void note_names(const std::vector<Token>& tokens, File& file);

/// What Python sees of an argument of a call, which these tokens are.
WrittenCall::Argument argument_of(const Value& value, std::span<const Token> tokens);

}  // namespace smurf::python
