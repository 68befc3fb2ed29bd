// SPDX-License-Identifier: BSD-3-Clause
#include "lint/masses.hpp"

#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "link/inertia.hpp"
#include "link/shape_solids.hpp"
#include "lint/body.hpp"
#include "lint/queries.hpp"
#include "smurf/lint.hpp"

namespace smurf {
namespace {

LinkMass mass_of(const LinkedModel& model, const urdf::Link& link) {
  LinkMass row;
  row.link = link.name.value_or("");
  if (const auto extent = extent_of(model, link)) {
    const auto solid = solid_of(model, link);
    row.volume = solid ? solid->volume : extent->volume();
    row.is_box = !solid;
  }
  if (!link.inertial) return row;
  if (link.inertial->mass) row.mass = *link.inertial->mass;
  if (!row.mass || !(*row.mass > 0)) return row;
  if (row.volume) row.density = *row.mass / *row.volume;
  const auto moments = principal_moments(*link.inertial);
  if (moments && (*moments)[2] > 0) row.gyration = std::sqrt((*moments)[2] / *row.mass);
  return row;
}

/// Whether a finding is about the link that contains `span`.
bool is_about(const Diagnostic& finding, const Span& link) {
  const auto is_inside = [&](const Span& place) {
    return place.source == link.source && place.begin >= link.begin && place.begin < link.end;
  };
  if (is_inside(finding.span)) return true;
  // One finding of this rule is about several links.
  return finding.rule == &rules::sml1516_identity_inertia &&
         std::any_of(finding.labels.begin(), finding.labels.end(),
                     [&](const Label& label) { return is_inside(label.span); });
}

/// The findings about inertials, each at the link that contains it.
void add_verdicts(const LinkedModel& model, std::vector<LinkMass>& rows) {
  RuleSelection selection;
  selection.select = {"SML15"};
  DiagnosticSink sink;
  lint_model(model, selection, sink);
  const std::vector<urdf::Link>& links = model.robot->links;
  for (const Diagnostic& finding : sink.take()) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (!is_about(finding, links[i].span)) continue;
      std::vector<const Rule*>& rules = rows[i].reported;
      if (std::find(rules.begin(), rules.end(), finding.rule) == rules.end()) {
        rules.push_back(finding.rule);
      }
    }
  }
}

}  // namespace

std::vector<LinkMass> masses_of(const LinkedModel& model) {
  std::vector<LinkMass> rows;
  if (!model.robot) return rows;
  for (const urdf::Link& link : model.robot->links) rows.push_back(mass_of(model, link));
  add_verdicts(model, rows);
  return rows;
}

}  // namespace smurf
