// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/refusal.hpp"

#include <system_error>

#include "base/files/places.hpp"

namespace smurf {

std::string why_not_converted(std::span<const Diagnostic> findings, const LossOf& loss_of) {
  std::string why;
  for (const Diagnostic& finding : findings) {
    const auto loss = loss_of(finding);
    if (!loss || why.find(*loss) != std::string::npos) continue;
    why += (why.empty() ? "cannot be converted: " : ", ") + *loss;
  }
  return why;
}

Refusal refusal_for(std::span<const Diagnostic> findings, bool force, const LossOf& loss_of) {
  std::string why = why_not_converted(findings, loss_of);
  if (why.empty() || force) return {};
  return {std::move(why), Refusal::Cause::findings, true};
}

std::string folder_of_process() {
  std::error_code error;
  return places::current_folder(error).value_or("");
}

}  // namespace smurf
