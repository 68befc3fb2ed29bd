// SPDX-License-Identifier: BSD-3-Clause
#include "lint/inertia_slips.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "link/possible_inertia.hpp"
#include "link/shape_solids.hpp"
#include "lint/body.hpp"

namespace smurf {
namespace {

constexpr std::string_view kNames[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};

std::array<const Field<double>*, 6> fields_of(const urdf::Inertial& inertial) {
  return {&inertial.ixx, &inertial.iyy, &inertial.izz, &inertial.ixy, &inertial.ixz, &inertial.iyz};
}

bool is_possible(const Tensor& tensor) {
  const Vector3 moments = principal_of(tensor).moments;
  return is_positive_definite(moments) && triangle_excess(moments) <= kImpossibleExcess;
}

/// How far the principal moments of two tensors are from each other, as squares of logarithms.
double misfit(const Tensor& a, const Tensor& b) {
  const Vector3 one = principal_of(a).moments;
  const Vector3 other = principal_of(b).moments;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += std::pow(std::log(one[i] / other[i]), 2);
  return sum;
}

class InertiaSlips {
 public:
  InertiaSlips(const Tensor& written, const std::optional<Tensor>& shapes)
      : written_(written), shapes_(shapes) {}

  /// `rarity` is how much worse the shapes must fit to make another mistake likelier.
  void add(const Tensor& tensor, double rarity, const std::string& question) {
    if (tensor == written_ || !is_possible(tensor)) return;
    const double cost = rarity + (shapes_ ? misfit(tensor, *shapes_) : 0);
    constexpr double kMost = 12;  // a factor of seven in each moment
    if (shapes_ && cost > kMost) return;
    if (best_ && cost >= least_) return;
    best_ = InertiaSlip{tensor, question};
    least_ = cost;
  }
  const std::optional<InertiaSlip>& best() const { return best_; }

 private:
  const Tensor& written_;
  const std::optional<Tensor>& shapes_;
  std::optional<InertiaSlip> best_;
  double least_ = 0;
};

void add_orders(const Tensor& t, InertiaSlips& slips) {
  // The slots of URDF in their order: ixx, ixy, ixz, iyy, iyz, izz.
  const double slots[] = {t[0], t[3], t[4], t[1], t[5], t[2]};
  slips.add({slots[0], slots[2], slots[5], slots[1], slots[3], slots[4]}, 0.5,
            "are the entries in the order of a lower triangle? URDF has the order ixx ixy ixz iyy "
            "iyz izz");
  slips.add({slots[0], slots[1], slots[2], slots[3], slots[4], slots[5]}, 0.5,
            "are the entries in the order xx yy zz xy xz yz? URDF has the order ixx ixy ixz iyy "
            "iyz izz");
  slips.add({slots[0], slots[1], slots[2], slots[5], slots[4], slots[3]}, 1,
            "are the entries in the order xx yy zz yz xz xy? URDF has the order ixx ixy ixz iyy "
            "iyz izz");
}

void add_signs(const Tensor& t, InertiaSlips& slips) {
  Tensor positive = t;
  for (std::size_t i = 0; i < 3; ++i) {
    positive[i] = std::fabs(t[i]);
    Tensor one = t;
    one[i] = std::fabs(t[i]);
    if (t[i] < 0) slips.add(one, 0.2, "is the sign of `" + std::string(kNames[i]) + "` wrong?");
  }
  slips.add(positive, 0.5, "are the signs of the moments wrong?");
  for (std::size_t i = 3; i < 6; ++i) {
    Tensor one = t;
    one[i] = -t[i];
    slips.add(one, 0.7, "is the sign of `" + std::string(kNames[i]) + "` wrong?");
  }
}

void add_decimal_points(const Tensor& t, InertiaSlips& slips) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (int digits = -6; digits <= 6; ++digits) {
      Tensor one = t;
      one[i] = t[i] * std::pow(10.0, digits);
      // More digits are rarer, but a thousand is a unit.
      const double rarity = 0.5 + 0.1 * std::abs(digits % 3) + 0.05 * std::abs(digits);
      slips.add(one, rarity,
                "is the decimal point of `" + std::string(kNames[i]) + "` in the wrong place? " +
                    format_rounded(one[i], 6) + " fits");
    }
  }
}

/// A little too much is not of a slip, but of rounded or measured numbers.
void add_small_excess(const Tensor& t, InertiaSlips& slips) {
  constexpr double kSmall = 0.05;
  const Vector3 moments = principal_of(t).moments;
  const double excess = triangle_excess(moments);
  if (!is_positive_definite(moments) || excess > kSmall) return;
  slips.add(nearest_possible(t), 0,
            "rounded or measured numbers? The largest moment is " +
                format_rounded(100 * excess, 2) + " % beyond that of a body");
}

/// A tensor about the origin of the link instead of the centre of mass, or moved there twice.
void add_offsets(const Tensor& t, double mass, const Vector3& offset, InertiaSlips& slips) {
  slips.add(shifted(t, -mass, offset), 0.5,
            "is it about the origin of the link? URDF has it about the centre of mass");
  slips.add(shifted(t, mass, offset), 0.5,
            "was the mass times the distance of the centre of mass squared subtracted twice?");
}

/// A rod without thickness.
void add_rods(const Tensor& t, InertiaSlips& slips) {
  const double largest = std::max({t[0], t[1], t[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::fabs(t[i]) <= 1e-6 * largest)) continue;
    Tensor rod = t;
    const double others = std::fabs(t[(i + 1) % 3] - t[(i + 2) % 3]);
    rod[i] = std::max(0.01 * largest, 1.01 * others);
    slips.add(rod, 0.6,
              "is this a rod? Its moment about its axis, `" + std::string(kNames[i]) +
                  "`, is m r^2 / 2, and not 0");
  }
}

}  // namespace

std::string moments_of(const Tensor& tensor) {
  const Vector3 moments = principal_of(tensor).moments;
  return format_rounded(moments[0], 3) + ", " + format_rounded(moments[1], 3) + ", " +
         format_rounded(moments[2], 3);
}

Tensor tensor_of(const urdf::Inertial& inertial) {
  Tensor tensor{};
  const auto fields = fields_of(inertial);
  for (std::size_t i = 0; i < tensor.size(); ++i) tensor[i] = **fields[i];
  return tensor;
}

std::optional<Tensor> tensor_of_shapes(const LinkedModel& model, const urdf::Link& link) {
  const auto extent = extent_of(model, link);
  if (!extent || !link.inertial || !(link.inertial->mass.value_or(0) > 0)) return std::nullopt;
  const auto solid = solid_of(model, link);
  Tensor tensor = unit_inertia(solid ? *solid : block({extent->low, extent->high}));
  for (double& entry : tensor) entry *= *link.inertial->mass;
  const Quaternion& q = urdf::to_pose(link.inertial->origin).orientation;
  return rotated(tensor, {q.w, -q.x, -q.y, -q.z});
}

std::optional<InertiaSlip> likely_slip(const LinkedModel& model, const urdf::Link& link) {
  const urdf::Inertial& inertial = *link.inertial;
  for (const Field<double>* field : fields_of(inertial)) {
    if (!*field) return std::nullopt;
  }
  const Tensor written = tensor_of(inertial);
  if (is_possible(written) || is_nothing(written, inertial.mass.value_or(0))) return std::nullopt;
  const std::optional<Tensor> shapes = tensor_of_shapes(model, link);
  InertiaSlips slips(written, shapes);
  const Pose X = urdf::to_pose(inertial.origin);
  const Quaternion& q = X.orientation;
  add_offsets(written, inertial.mass.value_or(0), rotate({q.w, -q.x, -q.y, -q.z}, X.position),
              slips);
  add_signs(written, slips);
  add_orders(written, slips);
  add_decimal_points(written, slips);
  add_rods(written, slips);
  add_small_excess(written, slips);
  return slips.best();
}

void add_likely_slip(const LinkedModel& model, const urdf::Link& link, Diagnostic& diagnostic) {
  const std::optional<InertiaSlip> slip = likely_slip(model, link);
  if (!slip) return;
  diagnostic.help(slip->question);
  if (auto fix = fix_of(*link.inertial, slip->tensor)) {
    diagnostic.fixes.push_back(std::move(*fix));
  }
}

bool is_nothing(const Tensor& tensor, double mass) {
  constexpr double kNothing = 1e-10;  // m2, of a radius of gyration of 0.01 mm
  return std::all_of(tensor.begin(), tensor.end(),
                     [&](double entry) { return std::fabs(entry) <= kNothing * mass; });
}

std::optional<Fix> fix_of(const urdf::Inertial& inertial, const Tensor& tensor) {
  constexpr int kDigits = 7;
  const auto fields = fields_of(inertial);
  double scale = 0;
  for (const double entry : tensor) scale = std::max(scale, std::fabs(entry));
  Fix fix{Applicability::unsafe, {}};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i]->written || fields[i]->span.empty()) return std::nullopt;
    constexpr double kRounding = 1e-9;
    const double value = std::fabs(tensor[i]) < kRounding * scale ? 0 : tensor[i];
    if (*fields[i] && std::fabs(**fields[i] - value) <= kRounding * scale) continue;
    fix.edits.push_back({fields[i]->span, format_rounded(value, kDigits)});
  }
  return fix.edits.empty() ? std::nullopt : std::optional(std::move(fix));
}

}  // namespace smurf
