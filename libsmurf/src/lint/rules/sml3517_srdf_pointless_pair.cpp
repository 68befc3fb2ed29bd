// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <tuple>

#include "base/text/counted.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3517_srdf_pointless_pair_file {
namespace {

/// The pairs of one SRDF that add nothing: one finding and one fix for all of them.
class Pointless {
 public:
  explicit Pointless(Findings& findings) : findings_(findings) {}

  void add(const srdf::Description& srdf, const srdf::LinkPair& pair, const std::string& message,
           const srdf::LinkPair* first = nullptr) {
    const xml::View element(srdf.document, pair.element);
    if (found_ == nullptr) {
      found_ = &findings_.report(element.name_span(), message);
      if (first != nullptr) found_->label(tag_of(srdf, first->element), "it is first here");
      found_->help("delete it");
      found_->fixes.push_back({Applicability::safe, {}});
    }
    ++count_;
    found_->fixes.front().edits.push_back({element.span(), ""});
  }

  void finish() {
    if (count_ > 1) found_->note(counted(count_ - 1, "more pair") + " of this SRDF add nothing");
  }

 private:
  Findings& findings_;
  Diagnostic* found_ = nullptr;
  std::size_t count_ = 0;
};

/// A link without collision geometry, of a robot that has some.
class NeverCollides {
 public:
  explicit NeverCollides(const LinkedModel& model) : model_(model) {
    for_each_link(model, [&](const urdf::Link& link) { any_ = any_ || !link.collisions.empty(); });
  }
  bool operator()(std::string_view name) const {
    const urdf::Link* link = any_ ? model_.find_link(name) : nullptr;
    return link != nullptr && link->collisions.empty();
  }

 private:
  const LinkedModel& model_;
  bool any_ = false;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const NeverCollides never_collides(model);
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    Pointless pointless(findings);
    std::map<std::tuple<bool, std::string_view, std::string_view>, const srdf::LinkPair*> known;
    for (const srdf::LinkPair& pair : srdf.pairs) {
      if (!pair.link1 || !pair.link2) continue;
      std::string_view a = *pair.link1, b = *pair.link2;
      if (a == b) {
        pointless.add(srdf, pair, "this pair names the link " + quoted(a) + " twice");
        continue;
      }
      if (b < a) std::swap(a, b);
      const auto [first, is_new] = known.emplace(std::tuple(pair.is_enabled, a, b), &pair);
      if (is_new && !pair.is_enabled && (never_collides(a) || never_collides(b))) {
        pointless.add(srdf, pair,
                      "the link " + quoted(never_collides(a) ? a : b) +
                          " of this pair has no collision geometry");
      }
      if (is_new) continue;
      pointless.add(srdf, pair, "the pair of " + quoted(a) + " and " + quoted(b) + " is here again",
                    first->second);
    }
    pointless.finish();
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::takes, "loads the robot as if it were not there",
     "srdfdom model.cpp loadCollisionPairs"},
};

}  // namespace

extern constinit const Rule sml3517_srdf_pointless_pair{
    .id = "SML3517",
    .name = "srdf-pointless-pair",
    .severity = Severity::info,
    .summary = "A pair of links is repeated, or both links are the same.",
    .remedy = "Delete the pair.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3517_srdf_pointless_pair_file
