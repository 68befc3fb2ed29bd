// SPDX-License-Identifier: BSD-3-Clause
// The mistakes that make a tensor impossible, undone one by one.
#pragma once

#include <optional>
#include <string>

#include "link/possible_inertia.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A possible tensor, and the mistake that makes the written one of it.
struct InertiaSlip {
  Tensor tensor{};       ///< in the frame of the inertial
  std::string question;  ///< "is the decimal point of `izz` in the wrong place?"
};
/// The mistake that explains an impossible tensor best. None if no mistake does, or if an entry is
/// not readable.
std::optional<InertiaSlip> likely_slip(const LinkedModel& model, const urdf::Link& link);

/// Adds the mistake to a finding, and a fix that undoes it.
void add_likely_slip(const LinkedModel& model, const urdf::Link& link, Diagnostic& diagnostic);

/// The principal moments, rounded for a message: "0.1, 0.2, 0.2".
std::string moments_of(const Tensor& tensor);
/// The entries as written. Precondition: all are readable.
Tensor tensor_of(const urdf::Inertial& inertial);
/// The two products whose sign a mirror along an axis changes, as indices of a Tensor: xy and xz
/// for x.
inline constexpr std::size_t kMirroredProducts[3][2] = {{3, 4}, {3, 5}, {4, 5}};
/// The tensor of the shapes of a link with its mass, in the frame of the inertial, about the centre
/// of the shapes. None without shapes or mass.
std::optional<Tensor> tensor_of_shapes(const LinkedModel& model, const urdf::Link& link);

/// Whether a tensor is 0, apart from rounding errors: even the nearest possible one is then that of
/// a point.
bool is_nothing(const Tensor& tensor, double mass);

/// A fix that writes the entries which differ; none if an entry is not written.
std::optional<Fix> fix_of(const urdf::Inertial& inertial, const Tensor& tensor);

}  // namespace smurf
