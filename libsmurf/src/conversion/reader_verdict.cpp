// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/reader_verdict.hpp"
#include "base/text/lists.hpp"

#include <algorithm>

namespace smurf {

ReaderVerdict verdict_on(const std::string& path, const Reader& reader, const FileReader& files,
                         const Limits& limits, const std::map<std::string, std::string>& packages) {
  Session session(files, limits);
  CheckSettings settings;
  settings.is_isolated = true;
  settings.packages = packages;
  settings.heeds_comments = settings.heeds_baseline = false;
  settings.selection.targets = {&reader};
  settings.jobs = 1;
  const Report report = session.check(path, settings);
  // The verdict of the whole file: parts that the reader does not look at do not count.
  const bool is_refused = !report.targets.empty() && report.targets.front().refusals > 0;
  ReaderVerdict verdict;
  for (const Diagnostic& finding : report.diagnostics) {
    const Fact* fact = find_fact(reader, finding);
    if (fact == nullptr || fact->effect < Effect::loses) continue;
    const bool refuses = is_refused && fact->effect >= Effect::refuses;
    std::vector<std::string>& reasons = refuses ? verdict.refused : verdict.lost;
    std::string reason = std::string(fact->makes) + " (" + std::string(finding.rule->id) +
                         (finding.pointer.empty() ? "" : " at " + finding.pointer) + ")";
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
      reasons.push_back(std::move(reason));
    }
  }
  return verdict;
}

std::string first_of(const std::vector<std::string>& reasons) { return shortlist(reasons, 1); }

}  // namespace smurf
