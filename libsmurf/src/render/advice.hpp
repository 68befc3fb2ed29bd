// SPDX-License-Identifier: BSD-3-Clause
// What to do about a finding.
#pragma once

#include <string>

#include "smurf/diagnostic.hpp"

namespace smurf::render {

/// The help of the finding. For an error or a warning without help and without fix, the first
/// sentence of the remedy of its rule, in the form of a help: "write the mass".
inline std::string advice_on(const Diagnostic& finding) {
  if (!finding.help_text.empty()) return finding.help_text;
  if (finding.severity == Severity::info || !finding.fixes.empty()) return {};
  std::string text(finding.rule->remedy);
  for (std::size_t stop = text.find(". "); stop != std::string::npos;
       stop = text.find(". ", stop + 1)) {
    const char next = text[stop + 2];
    if (next < 'A' || next > 'Z') continue;
    text.resize(stop);
    break;
  }
  if (text.ends_with('.')) text.pop_back();
  const bool is_word = text.size() > 1 && text[1] >= 'a' && text[1] <= 'z';
  if (is_word && text[0] >= 'A' && text[0] <= 'Z') text[0] += 'a' - 'A';
  return text;
}

}  // namespace smurf::render
