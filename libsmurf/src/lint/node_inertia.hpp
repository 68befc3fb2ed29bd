// SPDX-License-Identifier: BSD-3-Clause
// Inertias that entries of a SMURF give to nodes of MARS: the keys i00 to i22.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "link/possible_inertia.hpp"
#include "lint/body.hpp"
#include "lint/inertia_repair.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// The names of the nine entries, by rows.
inline constexpr std::array<std::string_view, 9> kNodeEntries = {"i00", "i01", "i02", "i10", "i11",
                                                                 "i12", "i20", "i21", "i22"};

/// An inertia about the centre of a node, along its axes.
struct NodeInertia {
  std::string title;         ///< "node `x`"
  Span place;                ///< of the first entry that is written
  Tensor tensor{};           ///< kg m^2
  bool is_symmetric = true;  ///< absent entries are 0, also below the diagonal
  std::array<std::optional<double>, 9> values;
  std::array<Span, 9> places{};  ///< within quotes; of absent entries empty
  std::optional<double> mass;    ///< kg, positive
  Span mass_place;               ///< empty if the mass is computed from a density
  std::optional<Solid> solid;    ///< of a box, sphere, cylinder or capsule
  std::optional<Extent> extent;  ///< of the same
};
/// Those that MARS uses and that are known without the URDF.
std::vector<NodeInertia> node_inertias(const LinkedModel& model);

/// What is wrong with the tensor, in words: "is not symmetric"; empty if nothing is.
std::string fault_of(const NodeInertia& node);

/// A fix that writes another tensor, and a note that says what was assumed.
struct NodeRepair {
  Fix fix;
  std::string note;
};
/// None if the source gives no tensor, or if an entry that it needs is not written.
std::optional<NodeRepair> repair_of(const NodeInertia& node, const InertiaSource& source);

}  // namespace smurf
