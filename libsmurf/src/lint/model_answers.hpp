// SPDX-License-Identifier: BSD-3-Clause
// What several rules ask of the same model, answered once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "link/possible_inertia.hpp"
#include "lint/body.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// Answers about a model, or about none; each is found at its first request.
class ModelAnswers {
 public:
  explicit ModelAnswers(const LinkedModel* model) : model_(model) {}

  /// doubtful_references() of the model; empty without one.
  std::span<const Reference> doubtful_references();

  // Of a link of the model:

  /// See extent_of().
  const std::optional<Extent>& extent(const urdf::Link& link);
  /// body_of() its inertial; none without one.
  const std::optional<Body>& body(const urdf::Link& link);
  /// unit_inertia() of the solid that its shapes are; none if they are none of known size.
  const std::optional<Tensor>& shape_inertia(const urdf::Link& link);

 private:
  struct OfLink {
    std::optional<std::optional<Extent>> extent;
    std::optional<std::optional<Body>> body;
    std::optional<std::optional<Tensor>> shape_inertia;
  };
  OfLink& of(const urdf::Link& link);

  const LinkedModel* model_;
  std::optional<std::vector<Reference>> references_;
  std::vector<OfLink> links_;
};

}  // namespace smurf
