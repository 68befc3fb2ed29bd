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
/// But for the trace, which is sent before.
std::string encode(const CheckResult& result);
/// The text before the rows of a trace, which are sent unchanged.
std::string encode_trace_begin(std::size_t size);

/// What a child wrote before its end.
struct Message {
  std::optional<Stage> last_stage;  ///< that was begun
  CheckResult so_far;               ///< of the stages before it
  std::string fault;                ///< what ODE says of why it gives up
  std::optional<CheckResult> result;
};
/// The output is taken apart, as a trace in it is long.
Message decode(std::string output);

}  // namespace smurf::load_check
