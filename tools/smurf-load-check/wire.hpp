// SPDX-License-Identifier: BSD-3-Clause
// The result of a check as text, from the child process that ran it.
#pragma once

#include <optional>
#include <string>

#include "smurf-load-check/result.hpp"

namespace smurf::load_check {

/// One line each.
std::string encode_begin(Stage stage);
std::string encode_fault(const std::string& message);
/// Everything except the trace, which is sent before.
std::string encode(const CheckResult& result);
/// The text before the rows of a trace, which are sent unchanged.
std::string encode_trace_begin(std::size_t size);

/// The output of a child before its end.
struct Message {
  std::optional<Stage> last_stage;  ///< that was begun
  CheckResult so_far;               ///< result of the earlier stages
  std::string fault;                ///< message of ODE about giving up
  std::optional<CheckResult> result;
};
/// The output is moved from, because its trace is long.
Message decode(std::string output);

}  // namespace smurf::load_check
