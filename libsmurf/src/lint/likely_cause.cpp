// SPDX-License-Identifier: BSD-3-Clause
#include "lint/likely_cause.hpp"

#include <algorithm>
#include <cmath>

#include "base/ranges.hpp"
#include "link/shape_solids.hpp"

namespace smurf {
namespace {

/// A usual mistake, and the factors that correct it.
struct Mistake {
  Culprit culprit;
  double mass, inertia, length;
  double rarity;              ///< how much worse another mistake must fit to be less likely
  std::string_view question;  ///< of a shape: without "is the mesh"
};
using enum Culprit;
constexpr Mistake kMistakes[] = {
    {inertia, 1, 1e-9, 1, 1, "is it in g mm2?"},
    {inertia, 1, 1e-6, 1, 1, "is it in kg mm2?"},
    {inertia, 1, 1e-7, 1, 2, "is it in g cm2?"},
    {inertia, 1, 1e-4, 1, 1.5, "is it in kg cm2?"},
    {inertia, 1, 2.926e-4, 1, 3, "is it in lb in2?"},
    {inertia, 1, 1e-3, 1, 1.5, "is it in g m2?"},
    {inertia, 1, 0.1, 1, 2, "is it 10 times too large?"},
    {inertia, 1, 0.01, 1, 2, "is it 100 times too large?"},
    {inertia, 1, 1e3, 1, 1.5, "is it 1000 times too small?"},
    {inertia, 1, 1e6, 1, 1.5, "is it a million times too small?"},
    {inertia, 1, 1e9, 1, 2, "is it 1e9 times too small?"},
    {inertia, 1, 10, 1, 2, "is it 10 times too small?"},
    {inertia, 1, 100, 1, 2, "is it 100 times too small?"},
    {mass, 1e-3, 1, 1, 1, "is the mass in grams?"},
    {mass, 1e3, 1, 1, 1.5, "is the mass in tonnes?"},
    {mass_and_inertia, 1e-3, 1e-9, 1, 1.5, "are mass and inertia in g and g mm2?"},
    {mass_and_inertia, 1e-3, 1e-3, 1, 2, "are mass and inertia in g and g m2?"},
    {mass_and_inertia, 1e-3, 1e-6, 1, 2, "are mass and inertia in g and kg mm2?"},
    {shape, 1, 1, 1e-3, 1, "in millimetres? It is 1000 times too large"},
    {shape, 1, 1, 1e3, 1, "scaled twice? It is 1000 times too small"},
    {shape, 1, 1, 0.1, 2, "10 times too large?"},
    {shape, 1, 1, 10, 2, "10 times too small?"},
    {shape, 1, 1, 0.01, 2, "in centimetres? It is 100 times too large"},
    {shape, 1, 1, 100, 2, "100 times too small?"},
    {shape, 1, 1, 1 / 25.4, 2.5, "25.4 times too large, millimetres read as inches?"},
    {shape, 1, 1, 25.4, 2.5, "25.4 times too small, inches read as millimetres?"},
    {shape, 1, 1, 0.0254, 2.5, "in inches? It is 39.4 times too large"},
};

/// Values of a material and of a body that fills its shapes, and how widely real ones spread.
struct Usual {
  double lightest, heaviest;              ///< kg/m3
  double least_inertia, most_inertia;     ///< of the full shape
  double density = 700;                   ///< kg/m3, the median of robots
  double density_spread = std::log(3);    ///< of its logarithm
  double inertia_spread = std::log(1.7);  ///< of its logarithm
};
constexpr double kFoam = 30;     // kg/m3
constexpr double kLead = 11340;  // kg/m3
const Usual kFullShape{kFoam, kLead, 0.3, 3};
const Usual kBoxAround{kFoam / 3, kLead, 0.1, 3};  // part of the box is empty

double misfit(const Usual& usual, double density, double inertia) {
  return std::pow(std::log(density / usual.density) / usual.density_spread, 2) +
         std::pow(std::log(inertia) / usual.inertia_spread, 2);
}

bool is_usual(const Usual& usual, double density, double inertia) {
  return density >= usual.lightest && density <= usual.heaviest && inertia >= usual.least_inertia &&
         inertia <= usual.most_inertia;
}

bool has_only_meshes(const urdf::Link& link) {
  const auto is_other = [](const auto& one) {
    return !std::holds_alternative<urdf::Mesh>(one.geometry.shape);
  };
  return !ranges::any_of(link.visuals, is_other) && !ranges::any_of(link.collisions, is_other);
}

/// Whether a number has at most two digits that count: 0.01, 3e-9, 25.
bool is_round(double value) {
  const double digits = value / std::pow(10, std::floor(std::log10(value)) - 1);
  return std::fabs(digits - std::round(digits)) < 1e-9 * digits;
}

/// Three equal round moments are what people write when they do not know the inertia: it says
/// nothing about its unit.
bool is_placeholder(const urdf::Link& link) {
  if (!link.inertial) return false;
  const double xx = link.inertial->ixx.value_or(0);
  return xx > 0 && xx == link.inertial->iyy.value_or(0) && xx == link.inertial->izz.value_or(0) &&
         is_round(xx);
}

double trace(const Solid& solid) { return solid.second[0] + solid.second[1] + solid.second[2]; }

}  // namespace

Cause likely_cause(const LinkedModel& model, const urdf::Link& link, const Body& body,
                   const Extent& extent) {
  const std::optional<Solid> solid = solid_of(model, link);
  const Usual& usual = solid ? kFullShape : kBoxAround;
  const Solid full = solid ? *solid : block({extent.low, extent.high});
  const double density = body.mass / full.volume;
  const double inertia =
      (body.second_moments[0] + body.second_moments[1] + body.second_moments[2]) /
      (trace(full) * density);
  const Mistake* best = nullptr;
  double least = 0;
  const bool has_inertia = !is_placeholder(link);
  for (const Mistake& one : kMistakes) {
    if (!has_inertia && one.inertia != 1) continue;
    const double corrected = density * one.mass / std::pow(one.length, 3);
    const double ratio = inertia * one.inertia / (one.mass * one.length * one.length);
    if (!is_usual(usual, corrected, ratio)) continue;
    const double cost = misfit(usual, corrected, ratio) + one.rarity;
    if (best != nullptr && cost >= least) continue;
    best = &one;
    least = cost;
  }
  if (best == nullptr) return {};
  std::string question(best->question);
  if (best->culprit == shape) {
    question.insert(0, has_only_meshes(link) ? "is the mesh " : "is the shape ");
  }
  return {best->culprit, std::move(question), best->inertia};
}

}  // namespace smurf
