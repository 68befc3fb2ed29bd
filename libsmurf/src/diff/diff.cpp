// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/diff.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "base/ranges.hpp"
#include "diff/collect.hpp"
#include "diff/compare.hpp"
#include "diff/match.hpp"

namespace smurf {
namespace {

/// The differences of two models, and the renames that follow from them in the scene.
struct ModelDiff {
  std::vector<Difference> differences;
  std::map<std::pair<NameKind, std::string>, std::string> renamed;
};

ModelDiff diff_models(const LinkedModel& before, const LinkedModel& after,
                      const DiffOptions& options, FileContents& contents) {
  YamlProperties properties;
  const Scope scope = before.has_main == after.has_main ? Scope::all : Scope::robot;
  const Things old_things = collect(before, scope, properties);
  const Things new_things = collect(after, scope, properties);
  Renames renames(old_things.references);
  const Matching matching = match(old_things, new_things, renames);
  return {compare(old_things, new_things, matching, renames, options, contents),
          renames.of_model(ModelIndex{Reference::kNothing})};
}

void set_models(std::vector<Difference>& differences, ModelIndex before, ModelIndex after) {
  for (Difference& one : differences) {
    one.old_model = before;
    one.new_model = after;
  }
}

/// A key that is equal for models with the same meaning.
std::uint64_t hash_of(const LinkedModel& model) {
  YamlProperties properties;
  const Things things = collect(model, Scope::all, properties);
  Renames names(things.references);
  for (std::uint8_t kind = 0; kind <= static_cast<std::uint8_t>(NameKind::extension); ++kind) {
    names.close(NameKind{kind});
  }
  std::uint64_t sum = 0;
  for (const Thing& thing : things.all) {
    const std::uint64_t name = std::hash<std::string>{}(thing.kind + '\0' + thing.name);
    sum += (hash_of(thing.properties, names) ^ name) * 0x9E3779B97F4A7C15U;
  }
  return sum;
}

class SceneDiff {
 public:
  SceneDiff(const LinkedScene& before, const LinkedScene& after, const SourceMap& sources,
            const DiffOptions& options)
      : before_(before), after_(after), options_(options), contents_(options) {
    YamlProperties properties;
    old_things_ = collect(before, sources, properties);
    new_things_ = collect(after, sources, properties);
  }

  std::vector<Difference> run() {
    Renames renames(old_things_.references);
    const Matching matching = match(old_things_, new_things_, renames);
    const auto old_models = models_of(before_, old_things_);
    const auto new_models = models_of(after_, new_things_);
    for (const auto& [thing, model] : new_models) {
      const auto old_model = old_models.find(matching.to_old[thing]);
      if (old_model == old_models.end()) continue;
      compare_models(old_model->second, model, matching.to_old[thing], thing, renames);
    }
    std::vector<Difference> all =
        compare(old_things_, new_things_, matching, renames, options_, contents_);
    tell_effects(all);
    std::move(of_models_.begin(), of_models_.end(), std::back_inserter(all));
    return all;
  }

 private:
  using Models = std::map<std::size_t, ModelIndex>;

  /// The models of entities, by thing. Things of entities are in the order of the files.
  static Models models_of(const LinkedScene& scene, const Things& things) {
    std::map<Span, std::size_t, decltype(&is_before)> places(is_before);
    for (std::size_t i = 0; i < things.all.size(); ++i) {
      if (things.all[i].names == NameKind::entity) places.emplace(things.all[i].place, i);
    }
    Models models;
    for (const Instance& instance : scene.instances) {
      if (!instance.model) continue;
      const auto thing = places.find(place_of(scene.entity(instance)));
      if (thing != places.end()) models.try_emplace(thing->second, *instance.model);
    }
    return models;
  }

  static Property* file_of(Thing& thing) {
    const auto file = ranges::find(thing.properties.members, "file", &Property::key);
    return file == thing.properties.members.end() ? nullptr : &*file;
  }

  /// Compares models of the same name. A model of another name is a different one, unless both mean
  /// the same.
  void compare_models(ModelIndex before, ModelIndex after, std::size_t old_thing,
                      std::size_t new_thing, Renames& renames) {
    const LinkedModel& old_model = before_.models[to_size(before)];
    const LinkedModel& new_model = after_.models[to_size(after)];
    Property* old_file = file_of(old_things_.all[old_thing]);
    Property* new_file = file_of(new_things_.all[new_thing]);
    if (old_file != nullptr && new_file != nullptr && old_file->text != new_file->text) {
      if (hash(old_hashes_, before, old_model) == hash(new_hashes_, after, new_model)) {
        old_file->text = new_file->text;
      }
      return;
    }
    if (of_models_.size() > options_.limits.differences) return;
    if (!compared_.emplace(before, after).second) return;
    ModelDiff found = diff_models(old_model, new_model, options_, contents_);
    set_models(found.differences, before, after);
    for (const auto& [name, new_name] : found.renamed) {
      renames.add(name.first, name.second, new_name, before);
    }
    std::move(found.differences.begin(), found.differences.end(), std::back_inserter(of_models_));
  }

  /// The number of entities that move with an entity: those in it and those placed on it.
  void tell_effects(std::vector<Difference>& differences) const {
    std::map<std::string, Difference*> moved;
    for (Difference& one : differences) {
      const bool is_placed = one.property == "placement" || one.property == "parent";
      if (one.kind == "entity" && is_placed) moved.try_emplace(one.name, &one);
    }
    if (moved.empty()) return;
    const std::vector<Difference*> causes = causes_of(after_, moved);
    std::map<Difference*, std::size_t> counts;
    for (Difference* cause : causes) ++counts[cause];
    for (const auto& [cause, count] : counts) {
      const bool is_more = cause != nullptr && count > 1;
      if (is_more) cause->detail = "moves " + std::to_string(count) + " entities";
    }
  }

  /// The difference that moved each instance: its own, that of its parent, or that of an enclosing
  /// scene; null: none.
  static std::vector<Difference*> causes_of(const LinkedScene& scene,
                                            const std::map<std::string, Difference*>& moved) {
    const auto own = [&](const std::string& path) {
      const auto found = moved.find(path);
      return found == moved.end() ? nullptr : found->second;
    };
    std::vector<Difference*> of_uses;
    for (const SceneUse& use : scene.uses) {
      Difference* cause = use.outer ? own(use.path) : nullptr;
      if (cause == nullptr && use.outer) cause = of_uses[to_size(*use.outer)];
      of_uses.push_back(cause);
    }
    std::vector<Difference*> causes(scene.instances.size());
    std::vector<char> is_known(scene.instances.size());
    for (std::size_t first = 0; first < causes.size(); ++first) {
      std::vector<std::size_t> chain;  // from an instance to the instance it is placed on
      for (std::size_t i = first; !std::exchange(is_known[i], 1);) {
        chain.push_back(i);
        const Attachment& parent = scene.instances[i].placement.parent;
        if (parent.kind != Attachment::Kind::link) break;
        i = to_size(parent.instance);
      }
      for (auto i = chain.rbegin(); i != chain.rend(); ++i) {
        const Instance& instance = scene.instances[*i];
        const Attachment& parent = instance.placement.parent;
        causes[*i] = own(instance.path);
        const bool is_placed = parent.kind == Attachment::Kind::link;
        if (causes[*i] == nullptr) causes[*i] = of_uses[to_size(instance.use)];
        if (causes[*i] == nullptr && is_placed) causes[*i] = causes[to_size(parent.instance)];
      }
    }
    return causes;
  }

  using Hashes = std::map<ModelIndex, std::uint64_t>;
  static std::uint64_t hash(Hashes& hashes, ModelIndex index, const LinkedModel& model) {
    const auto [place, is_new] = hashes.try_emplace(index);
    if (is_new) place->second = hash_of(model);
    return place->second;
  }

  const LinkedScene& before_;
  const LinkedScene& after_;
  const DiffOptions& options_;
  FileContents contents_;
  Things old_things_, new_things_;
  Hashes old_hashes_, new_hashes_;
  std::set<std::pair<ModelIndex, ModelIndex>> compared_;
  std::vector<Difference> of_models_;
};

}  // namespace

std::string_view to_string(Change change) {
  static constexpr std::array<std::string_view, 4> kWords = {"added", "removed", "renamed",
                                                             "changed"};
  return kWords[static_cast<std::size_t>(change)];
}

std::vector<Difference> diff(const LinkedModel& before, const LinkedModel& after, const SourceMap&,
                             const DiffOptions& options) {
  FileContents contents(options);
  std::vector<Difference> found = diff_models(before, after, options, contents).differences;
  set_models(found, ModelIndex{0}, ModelIndex{0});
  return found;
}

std::vector<Difference> diff(const LinkedScene& before, const LinkedScene& after,
                             const SourceMap& sources, const DiffOptions& options) {
  return SceneDiff(before, after, sources, options).run();
}

}  // namespace smurf
