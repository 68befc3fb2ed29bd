// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5014_ambiguous_entity_name_file {
namespace {

struct Named {
  InstanceIndex first{};
  std::size_t count = 0;
};

class Ambiguities {
 public:
  Ambiguities(const LinkedScene& scene, Findings& findings) : scene_(scene), findings_(findings) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      Named& named = names_[scene.instances[i].name];
      if (named.count++ == 0) named.first = InstanceIndex{static_cast<std::uint32_t>(i)};
    }
  }

  void check(const Use& use) {
    check(use, use.entity.parent, use.placement.parent);
    if (use.entity.anchor && *use.entity.anchor != "parent") {
      check(use, use.entity.anchor, use.placement.anchor);
    }
  }

 private:
  /// Whether the scene of `outer` is that of `inner` or around it.
  bool encloses(const SceneUse& outer, const SceneUse& inner) const {
    for (const SceneUse* at = &inner;; at = &scene_.uses[to_size(*at->outer)]) {
      if (at == &outer) return true;
      if (!at->outer) return false;
    }
  }

  void check(const Use& use, const Field<std::string>& reference, const Attachment& meant) {
    if (!reference || meant.kind != Attachment::Kind::link) return;
    if (reference->find("::") == std::string::npos) return;
    const Instance& instance = scene_.instance(meant.instance);
    const Named& named = names_.at(instance.name);
    const Instance& first = scene_.instance(named.first);
    if (named.count == 1) return;
    if (named.first != meant.instance) {
      Diagnostic& diagnostic = findings_.report(
          reference.span, quoted(instance.name) + " means " + quoted(instance.path) +
                              " here, but MARS uses " + quoted(first.path));
      if (&scene_.entity(instance) != &scene_.entity(first)) {
        label(diagnostic, place_of(scene_.entity(instance)), "meant here");
        label(diagnostic, place_of(scene_.entity(first)), "the first of that name");
      } else {  // one entity, of a scene that is included twice
        label(diagnostic, include_place(instance), "meant here");
        label(diagnostic, include_place(first), "the first copy");
      }
    } else if (!encloses(scene_.use(instance), use.around)) {
      Diagnostic& diagnostic =
          findings_.report(reference.span, std::to_string(named.count) + " entities are called " +
                                               quoted(instance.name) + "; the first is used, " +
                                               quoted(instance.path));
      label(diagnostic, place_of(scene_.entity(first)), "the first of that name");
    }
  }

  Span include_place(const Instance& instance) const {
    const Entity* including = scene_.entity(scene_.use(instance));
    return including == nullptr ? place_of(scene_.entity(instance)) : place_of(*including);
  }

  static void label(Diagnostic& diagnostic, Span place, std::string text) {
    diagnostic.label(place, std::move(text));
  }

  const LinkedScene& scene_;
  Findings& findings_;
  std::map<std::string_view, Named> names_;
};

void check(const LinkedScene& scene, Findings& findings) {
  Ambiguities ambiguities(scene, findings);
  for_each_use(scene, [&](const Use& use) { ambiguities.check(use); });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "uses the first entity of that name in all scenes",
     "MARS EntityManager.cpp:229-239"},
};

}  // namespace

extern constinit const Rule sml5014_ambiguous_entity_name{
    .id = "SML5014",
    .name = "ambiguous-entity-name",
    .severity = Severity::warning,
    .summary = "A name refers to one entity in the scene that uses it, and to another in MARS.",
    .why =
        "An included scene is meant to refer to its own entities first, then to those around it.",
    .remedy = "Give the entities different names, or include the scene only once.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5014_ambiguous_entity_name_file
