// SPDX-License-Identifier: BSD-3-Clause
#include "lint/model_answers.hpp"

#include "link/shape_solids.hpp"

namespace smurf {

std::span<const Reference> ModelAnswers::doubtful_references() {
  if (!references_) {
    references_ =
        model_ != nullptr ? smurf::doubtful_references(*model_) : std::vector<Reference>();
  }
  return *references_;
}

ModelAnswers::OfLink& ModelAnswers::of(const urdf::Link& link) {
  const std::vector<urdf::Link>& links = model_->robot->links;
  links_.resize(links.size());
  return links_[static_cast<std::size_t>(&link - links.data())];
}

const std::optional<Extent>& ModelAnswers::extent(const urdf::Link& link) {
  OfLink& known = of(link);
  if (!known.extent) known.extent = extent_of(*model_, link);
  return *known.extent;
}

const std::optional<Body>& ModelAnswers::body(const urdf::Link& link) {
  OfLink& known = of(link);
  if (!known.body) known.body = link.inertial ? body_of(*link.inertial) : std::nullopt;
  return *known.body;
}

const std::optional<Tensor>& ModelAnswers::shape_inertia(const urdf::Link& link) {
  OfLink& known = of(link);
  if (!known.shape_inertia) {
    const std::optional<Solid> solid = solid_of(*model_, link);
    known.shape_inertia = solid ? std::optional(unit_inertia(*solid)) : std::nullopt;
  }
  return *known.shape_inertia;
}

}  // namespace smurf
