// SPDX-License-Identifier: BSD-3-Clause
#include "lint/inertia_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "link/shape_solids.hpp"
#include "lint/body.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/likely_cause.hpp"
#include "lint/node_inertia.hpp"
#include "lint/queries.hpp"
#include "smurf/lint.hpp"

namespace smurf {
namespace {

using From = InertiaSource::From;

constexpr std::array<std::string_view, 11> kRepairable = {
    "SML1505", "SML1511", "SML1512", "SML1513", "SML1514", "SML1516",
    "SML1518", "SML1519", "SML1523", "SML1531", "SML1533"};

/// A new inertia, and what was assumed.
struct Replacement {
  Tensor tensor{};
  double mass = 0;
  std::string assumption;
  double density = HUGE_VAL;  ///< kg/m3, if it is that of full shapes
};

/// The body of the shapes that a source uses.
std::optional<Solid> shapes_for(const LinkedModel& model, const urdf::Link& link, From from) {
  const auto extent = extent_of(model, link);
  if (!extent) return std::nullopt;
  const auto solid = from == From::box ? std::nullopt : solid_of(model, link);
  if (!solid && from == From::mesh) return std::nullopt;
  return solid ? solid : block({extent->low, extent->high});
}

Replacement of_shapes(const urdf::Link& link, const Solid& solid, const InertiaSource& source,
                      bool is_box) {
  const double mass = source.from == From::density ? source.density * solid.volume
                                                   : link.inertial->mass.value_or(0);
  Tensor tensor = unit_inertia(solid);
  for (double& entry : tensor) entry *= mass;
  const Quaternion& q = urdf::to_pose(link.inertial->origin).orientation;
  return {rotated(tensor, {q.w, -q.x, -q.y, -q.z}), mass,
          std::string(is_box ? "the box around its shapes" : "its shapes") + ", filled with " +
              format_rounded(mass, 4) + " kg, which is " + format_rounded(mass / solid.volume, 3) +
              " kg/m3",
          mass / solid.volume};
}

std::optional<Replacement> nearest_tensor(const urdf::Inertial& inertial) {
  const Tensor written = tensor_of(inertial);
  if (is_nothing(written, *inertial.mass)) return std::nullopt;
  return Replacement{nearest_possible(written), *inertial.mass,
                     "the nearest tensor that a body can have"};
}

std::optional<Replacement> replacement_for(const LinkedModel& model, const urdf::Link& link,
                                           const InertiaSource& source) {
  const urdf::Inertial& inertial = *link.inertial;
  if (!principal_moments(inertial) || !(inertial.mass.value_or(0) > 0)) return std::nullopt;
  if (source.from == From::nearest) return nearest_tensor(inertial);
  if (const auto solid = shapes_for(model, link, source.from)) {
    const bool is_box = source.from == From::box || !solid_of(model, link);
    return of_shapes(link, *solid, source, is_box);
  }
  if (source.from != From::mass) return std::nullopt;
  if (const auto slip = likely_slip(model, link)) {
    return Replacement{slip->tensor, *inertial.mass, slip->question};
  }
  return nearest_tensor(inertial);
}

double trace_of(const Tensor& tensor) { return tensor[0] + tensor[1] + tensor[2]; }

/// `<inertia ixx="1" .../>`
std::string element_of(const Tensor& tensor) {
  constexpr int kDigits = 7;
  constexpr double kRounding = 1e-9;
  constexpr std::array<std::size_t, 6> kPlaces = {0, 3, 4, 1, 5, 2};
  const double least = kRounding * trace_of(tensor);
  std::string text = "<inertia";
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const double entry = tensor[kPlaces[i]];
    text += " " + std::string(urdf::kInertiaEntries[i]) + "=\"" +
            format_rounded(std::fabs(entry) < least ? 0 : entry, kDigits) + "\"";
  }
  return text + "/>";
}

/// Writes the inertia of the shapes into an inertial that has none.
void add_fix(const LinkedModel& model, const urdf::Link& link, const InertiaSource& source,
             Diagnostic& finding) {
  finding.fixes.clear();
  const urdf::Inertial& inertial = *link.inertial;
  const xml::View mass = xml::View(model.robot->document, inertial.element).child("mass");
  if (!mass || !(inertial.mass.value_or(0) > 0) || source.from == From::nearest) return;
  const auto solid = shapes_for(model, link, source.from);
  if (!solid) return;
  const bool is_box = source.from == From::box || !solid_of(model, link);
  const Replacement made = of_shapes(link, *solid, source, is_box);
  Fix fix{Applicability::unsafe, {}};
  const Span after{mass.span().source, mass.span().end, mass.span().end};
  fix.edits.push_back({after, element_of(made.tensor)});
  if (made.mass != *inertial.mass) {
    fix.edits.push_back({inertial.mass.span, format_rounded(made.mass, 6)});
  }
  finding.notes = {"the principal moments become " + moments_of(made.tensor) + ": " +
                   made.assumption};
  finding.fixes.push_back(std::move(fix));
}

/// Lighter than foam: the shapes, or the mass, are not those of the part.
constexpr double kLeastDensity = 20;  // kg/m3

/// Whether it is the shape that is wrong, or the mass: a tensor of both would be as wrong.
bool is_about_shape(const LinkedModel& model, const urdf::Link& link) {
  const auto extent = extent_of(model, link);
  const auto body = body_of(*link.inertial);
  if (!extent || !body) return false;
  return likely_cause(model, link, *body, *extent).culprit == Culprit::shape;
}

void replace_fix(const LinkedModel& model, const urdf::Link& link, InertiaSource source,
                 Diagnostic& finding) {
  // What only rounding makes impossible is measured or computed, and better than a full shape.
  const bool is_rounded = finding.rule->id == std::string_view("SML1514");
  if (is_rounded && source.from != From::density) source.from = From::nearest;
  finding.fixes.clear();
  const bool is_of_shapes = source.from != From::nearest && source.from != From::density;
  if (is_of_shapes && is_about_shape(model, link)) return;
  const auto replacement = replacement_for(model, link, source);
  if (!replacement || (is_of_shapes && replacement->density < kLeastDensity)) return;
  const urdf::Inertial& inertial = *link.inertial;
  // What is too large only for its centre of mass does not become possible by another tensor.
  const bool is_too_large = finding.rule->id == std::string_view("SML1518");
  if (is_too_large && trace_of(replacement->tensor) >= trace_of(tensor_of(inertial))) return;
  auto fix = fix_of(inertial, replacement->tensor);
  if (!fix) return;
  if (replacement->mass != *inertial.mass) {
    fix->edits.push_back({inertial.mass.span, format_rounded(replacement->mass, 6)});
  }
  finding.notes = {"principal moments " + moments_of(tensor_of(inertial)) + " become " +
                   moments_of(replacement->tensor) + ": " + replacement->assumption};
  finding.fixes.push_back(std::move(*fix));
}

void replace_fix(const std::vector<NodeInertia>& nodes, const InertiaSource& source,
                 Diagnostic& finding) {
  finding.fixes.clear();
  const auto node = std::find_if(nodes.begin(), nodes.end(),
                                 [&](const NodeInertia& one) { return one.place == finding.span; });
  auto repair = node != nodes.end() ? repair_of(*node, source) : std::nullopt;
  if (!repair) return;
  finding.notes = {repair->note};
  finding.fixes.push_back(std::move(repair->fix));
}

/// The finding about the unit tensors of several links as one finding each.
std::vector<Diagnostic> split(const LinkedModel& model, std::vector<Diagnostic> findings) {
  std::vector<Diagnostic> all;
  for (Diagnostic& finding : findings) {
    if (finding.rule != &rules::sml1516_identity_inertia) {
      all.push_back(std::move(finding));
      continue;
    }
    const std::vector<Label> labels = std::exchange(finding.labels, {});
    finding.notes.clear();
    all.push_back(finding);
    for (const Label& label : labels) {
      Diagnostic& other = all.emplace_back(finding);
      other.span = label.span;
      for (const urdf::Link& link : model.robot->links) {
        const bool is_here =
            label.span.begin >= link.span.begin && label.span.begin < link.span.end;
        if (is_here) other.message = "the inertia of " + title(link) + " is the unit tensor, too";
      }
    }
  }
  return all;
}

}  // namespace

std::optional<InertiaSource> parse_inertia_source(std::string_view text) {
  constexpr std::pair<std::string_view, From> kWords[] = {
      {"mass", From::mass}, {"mesh", From::mesh}, {"box", From::box}, {"nearest", From::nearest}};
  for (const auto& [word, from] : kWords) {
    if (text == word) return InertiaSource{from, 0};
  }
  constexpr std::string_view kDensity = "density:";
  if (!text.starts_with(kDensity)) return std::nullopt;
  const auto density = parse_number(text.substr(kDensity.size()));
  if (!density || !(*density > 0)) return std::nullopt;
  return InertiaSource{From::density, *density};
}

bool is_repairable(const Rule& rule) {
  return std::find(kRepairable.begin(), kRepairable.end(), rule.id) != kRepairable.end();
}

std::vector<Diagnostic> repair_inertias(const LinkedModel& model, const InertiaSource& source) {
  RuleSelection selection;
  selection.select.assign(kRepairable.begin(), kRepairable.end());
  if (source.from == From::density) selection.select.emplace_back("SML1520");
  DiagnosticSink sink;
  lint_model(model, selection, sink);
  std::vector<Diagnostic> repairs;
  std::set<const urdf::Link*> done;
  const std::vector<NodeInertia> nodes = node_inertias(model);
  for (Diagnostic& finding : split(model, sink.take())) {
    if (finding.rule == &rules::sml1533_node_inertia) {
      replace_fix(nodes, source, finding);
      if (!finding.fixes.empty()) repairs.push_back(std::move(finding));
      continue;
    }
    for (const urdf::Link& link : model.robot->links) {
      const bool is_here = link.inertial && finding.span.begin >= link.span.begin &&
                           finding.span.begin < link.span.end;
      if (!is_here || !done.insert(&link).second) continue;
      if (finding.rule == &rules::sml1505_inertia_missing) {
        add_fix(model, link, source, finding);
      } else {
        replace_fix(model, link, source, finding);
      }
      if (!finding.fixes.empty()) repairs.push_back(std::move(finding));
      break;
    }
  }
  return repairs;
}

}  // namespace smurf
