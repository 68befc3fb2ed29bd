// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "lint/node_inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1533_node_inertia_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const NodeInertia& node : node_inertias(model)) {
    const std::string fault = fault_of(node);
    if (fault.empty()) continue;
    Diagnostic& diagnostic =
        findings.report(node.place, "the inertia of " + node.title + " " + fault);
    if (!node.is_symmetric) {
      diagnostic.help(
          "write equal numbers for `i01` and `i10`, `i02` and `i20`, `i12` and `i21`; an absent "
          "one is 0");
    }
    if (auto repair = repair_of(node, {})) {
      diagnostic.note(repair->note);
      diagnostic.help("write the moments of the shape, or delete `inertia`");
      diagnostic.fixes.push_back(std::move(repair->fix));
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "gives the nine numbers to ODE as they are: the node turns as no body of this size can",
     "MARS NodePhysics.cpp, setInertiaMass"},
};

}  // namespace

extern constinit const Rule sml1533_node_inertia{
    .id = "SML1533",
    .name = "node-inertia",
    .severity = Severity::warning,
    .summary = "The inertia of a node of MARS is not that of a body of its mass and size.",
    .why = "The node then spins up by itself, or turns as if its mass were metres away.",
    .remedy = "Compute `i00` to `i22` from the shape and the mass, in kg m2, or delete `inertia` "
              "so that MARS computes them.",
    .sources = "MARS NodeData.cpp and NodePhysics.cpp.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1533_node_inertia_file
