// SPDX-License-Identifier: BSD-3-Clause
#include "lint/exact_slip.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "base/text/quoted.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/model_answers.hpp"

namespace smurf {
namespace {

constexpr double kWrong = 0.1;   // of the tensor, as written
constexpr double kRight = 0.03;  // after the change

/// How far a tensor is from another one, as a part of it.
double distance_between(const Tensor& a, const Tensor& b) {
  double square = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double times = i < 3 ? 1 : 2;  // products stand in a matrix twice
    square += times * (a[i] - b[i]) * (a[i] - b[i]);
    size += times * b[i] * b[i];
  }
  return size > 0 ? std::sqrt(square / size) : HUGE_VAL;
}

/// The signs of the products: some programs write the integrals themselves, others their negatives.
void add_signs(const Tensor& written, std::vector<ExactSlip>& guesses) {
  for (unsigned signs = 1; signs < 8; ++signs) {
    Tensor tensor = written;
    std::string names;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((signs >> i & 1U) == 0 || tensor[3 + i] == 0) continue;
      tensor[3 + i] = -tensor[3 + i];
      constexpr std::string_view kNames[] = {"ixy", "ixz", "iyz"};
      names += (names.empty() ? "" : ", ") + quoted(kNames[i]);
    }
    if (tensor == written) continue;
    const bool are_several = names.find(',') != std::string::npos;
    guesses.push_back({tensor,
                       std::string("when the sign") + (are_several ? "s of " : " of ") + names +
                           (are_several ? " are" : " is") + " changed",
                       "the product `ixy` of URDF is the negative integral of x y"});
  }
}

void add_offsets(const Tensor& written, double mass, const Vector3& center,
                 std::vector<ExactSlip>& guesses) {
  if (center == Vector3{}) return;
  guesses.push_back({shifted(written, -mass, center),
                     "when it is moved from the origin of the link to the centre of mass",
                     "URDF has the inertia about the centre of mass"});
  guesses.push_back({shifted(written, mass, center),
                     "when the mass times the distance of the centre squared is added again",
                     "was it subtracted twice? URDF has the inertia about the centre of mass"});
}

}  // namespace

std::optional<ExactSlip> exact_slip(const urdf::Link& link, ModelAnswers& answers) {
  const std::optional<Body>& body = answers.body(link);
  if (!body || body->mass < kSmallestPart || !answers.extent(link)) return std::nullopt;
  const std::optional<Tensor>& unit = answers.shape_inertia(link);
  if (!unit) return std::nullopt;
  const Pose X = urdf::to_pose(link.inertial->origin);
  const Tensor written = tensor_of(*link.inertial);
  const Quaternion& q = X.orientation;
  const Quaternion back{q.w, -q.x, -q.y, -q.z};
  Tensor shape = rotated(*unit, back);
  for (double& entry : shape) entry *= body->mass;
  const double off = distance_between(written, shape);
  if (off < kWrong) return std::nullopt;
  std::vector<ExactSlip> guesses;
  add_signs(written, guesses);
  add_offsets(written, body->mass, rotate(back, X.position), guesses);
  std::optional<ExactSlip> best;
  double least = kRight;
  for (ExactSlip& guess : guesses) {
    const double distance = distance_between(guess.tensor, shape);
    if (distance >= least) continue;
    least = distance;
    best = std::move(guess);
    best->off = off;
  }
  return best;
}

}  // namespace smurf
