// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/replaced_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "base/text/wildcards.hpp"
#include "convert/xml_edits.hpp"
#include "link/imported_world.hpp"
#include "link/shape_solids.hpp"

namespace smurf {
namespace {

/// Exchanges the robots, and all that belongs to them and not to the annotations.
void exchange(LinkedModel& a, LinkedModel& b) {
  std::swap(a.robot, b.robot);
  std::swap(a.tree, b.tree);
  std::swap(a.link_names, b.link_names);
  std::swap(a.joint_names, b.joint_names);
  std::swap(a.visual_names, b.visual_names);
  std::swap(a.collision_names, b.collision_names);
  std::swap(a.material_names, b.material_names);
  std::swap(a.visual_materials, b.visual_materials);
  std::swap(a.meshes, b.meshes);
}

bool fits(const CollisionChoice& choice, const urdf::Link& link) {
  return choice.links.empty() || (link.name && matches(*link.name, choice.links));
}

bool fits_one(const CollisionChoice& choice, const LinkedModel& model) {
  return model.robot && std::any_of(model.robot->links.begin(), model.robot->links.end(),
                                    [&](const urdf::Link& link) { return fits(choice, link); });
}

}  // namespace

CollisionShapes shapes_for(const CollisionRequest& request, std::string_view link) {
  CollisionShapes shapes = CollisionShapes::keep;
  for (const CollisionChoice& choice : request.choices) {
    if (choice.links.empty() || matches(link, choice.links)) shapes = choice.shapes;
  }
  return shapes;
}

std::vector<CollisionChoice> choices_for(const CollisionRequest& request,
                                         const LinkedModel& model) {
  std::vector<CollisionChoice> choices;
  for (const CollisionChoice& choice : request.choices) {
    if (fits_one(choice, model)) choices.push_back(choice);
  }
  return choices;
}

std::string unknown_links(const CollisionRequest& request,
                          std::span<const LinkedModel* const> models) {
  for (const CollisionChoice& choice : request.choices) {
    const bool is_known = choice.links.empty() ||
                          std::any_of(models.begin(), models.end(), [&](const LinkedModel* model) {
                            return fits_one(choice, *model);
                          });
    if (!is_known) return "has no link that fits " + quoted(choice.links) + " of --collision";
  }
  return {};
}

void report_collisions(std::span<const ReplacedCollision> replaced, DiagnosticSink& sink) {
  for (const ReplacedCollision& one : replaced) {
    const std::string mesh = "collision mesh " + quoted(path::file_name(one.mesh));
    if (!one.kept.empty()) {
      sink.report(rules::sml8211_lost_part, one.place,
                  "the " + mesh + " is kept, although other shapes were asked for: " + one.kept);
      continue;
    }
    const std::string uses =
        one.collisions > 1 ? " (in " + counted(one.collisions, "collision") + ")" : "";
    sink.report(rules::sml8213_replaced_collision, one.place,
                "the " + mesh + uses + " becomes " + describe(one));
  }
}

ReplacedCollisions::ReplacedCollisions(Session& session, Loaded& loaded,
                                       const CollisionRequest& request, CollisionOutput output)
    : session_(session),
      loaded_(loaded),
      request_(request),
      output_(std::move(output)),
      files_(&session.files()) {}

Refusal ReplacedCollisions::apply(std::span<LinkedModel* const> models) {
  if (!request_.changes_something()) return {};
  const std::vector<const LinkedModel*> all(models.begin(), models.end());
  if (std::string problem = unknown_links(request_, all); !problem.empty())
    return {std::move(problem), Refusal::Cause::options};
  for (LinkedModel* model : models) find_uses(*model);
  if (Refusal refusal = make_shapes()) return refusal;
  before_.emplace(std::move(loaded_.found));
  loaded_.found = DiagnosticSink(session_.limits());
  for (LinkedModel* model : models) {
    if (Refusal refusal = change(*model)) {
      restore();
      return refusal;
    }
  }
  report();
  return {};
}

void ReplacedCollisions::find_uses(LinkedModel& model) {
  if (!model.robot) return;
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    const urdf::Link& link = model.robot->links[i];
    const CollisionShapes shapes = shapes_for(request_, link.name.value_or({}));
    if (shapes == CollisionShapes::keep) continue;
    for (std::size_t k = 0; k < link.collisions.size(); ++k) find_use(model, {i, k}, shapes);
  }
}

void ReplacedCollisions::find_use(LinkedModel& model, CollisionPlace place,
                                  CollisionShapes shapes) {
  const urdf::Geometry& geometry =
      model.robot->links[place.link].collisions[place.collision].geometry;
  const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
  const MeshReference* reference = mesh != nullptr ? find_reference(model, *mesh) : nullptr;
  // Others were reported, and are no meshes for any reader.
  if (reference == nullptr || !reference->exists || (mesh->scale.written && !mesh->scale)) return;
  const Vector3 scale = mesh->scale.value_or({1, 1, 1});
  const bool has_capsules = output_.has_capsules || model.robot->version.value_or("1.0") != "1.0";
  const std::string key = session_.files().identity(reference->path) +
                          path::to_lower(path::extension(reference->path)) + " " +
                          numbers_text(scale) + " " + std::to_string(static_cast<int>(shapes)) +
                          (has_capsules ? " capsule" : "");
  const auto [known, is_new] = jobs_.try_emplace(key);
  Job& job = known->second;
  if (is_new) {
    job.mesh = reference;
    job.scale = scale;
    job.shapes = shapes;
    job.has_capsules = has_capsules;
    if (const auto solid = solid_of(model, geometry)) job.volume = solid->volume;
    order_.push_back(&job);
  }
  ++job.uses;
  uses_.push_back({&model, place, &job});
}

Refusal ReplacedCollisions::make_shapes() {
  const auto needs = [&](CollisionShapes shapes) {
    return static_cast<std::size_t>(std::count_if(
        order_.begin(), order_.end(), [&](const Job* job) { return job->shapes == shapes; }));
  };
  const std::size_t divided = needs(CollisionShapes::parts);
  if (divided > 0 && !request_.divide)
    return {"cannot be converted: this program cannot divide meshes into convex parts; use "
            "smurfs-flatten or smurf2urdf, or --collision hull",
            Refusal::Cause::options};
  const std::size_t lighter = needs(CollisionShapes::lighter);
  if (lighter > 0 && !request_.lighten)
    return {"cannot be converted: this program cannot make meshes lighter; use smurfs-flatten or "
            "smurf2urdf, or --collision hull",
            Refusal::Cause::options};
  if (output_.names_meshes && request_.folder.empty() &&
      divided + lighter + needs(CollisionShapes::hull) > 0)
    return {"cannot be converted: the new meshes of --collision lie beside the result; name it "
            "with -o FILE",
            Refusal::Cause::options};
  CollisionShaper shaper(request_, session_.files(), session_.limits());
  if (request_.tell) {
    shaper.before_dividing([&] {
      // Measured on 25 meshes with two processors: 4 s for half of them, 76 s for the slowest.
      constexpr std::size_t kSeconds = 15;
      const std::size_t minutes = (divided * kSeconds + 59) / 60;
      request_.tell("dividing up to " + counted(divided, "mesh", "meshes") +
                    " into convex parts may take " + counted(minutes, "minute"));
    });
  }
  for (Job* job : order_) {
    job->made = shaper.make(*job->mesh, job->scale, job->shapes, job->volume, job->has_capsules);
    if (!shaper.problem().empty())
      return {"cannot be converted: " + shaper.problem(), Refusal::Cause::options};
    for (TextFile& file : job->made.files) {
      const std::string folder =
          places::absolute_from(output_.current_folder, output_.output_folder);
      files_.add(path::join(folder, file.path), file.text);
      meshes_.push_back(std::move(file));
    }
    job->made.about.collisions = job->uses;
    replaced_.push_back(job->made.about);
  }
  return {};
}

/// The path of a new mesh, relative to the folder of the URDF. It can be read by this path.
std::string ReplacedCollisions::name_in(const LinkedModel& model, const std::string& file) {
  const std::string& current = output_.current_folder;
  const std::string folder(path::parent(model.urdf_path));
  const std::string target =
      path::join(places::absolute_from(current, output_.output_folder), file);
  std::string name = path::relative(target, places::absolute_from(current, folder));
  const FileContent content = files_.read(target, session_.limits().mesh_bytes);
  files_.add(path::join(folder, name), content.text);
  return name;
}

/// The model of a changed text, read as the files of the session are.
std::optional<LinkedModel> ReplacedCollisions::load(const LinkedModel& model, std::string text) {
  LoadContext of_session = session_.context_of(loaded_);
  DiagnosticSink known(session_.limits());  // what is wrong with the robot was reported
  LoadContext context{
      of_session.sources,         files_,   known, of_session.limits, of_session.packages,
      of_session.package_folders, &library_};
  xacro::Expansion made;
  made.root = made.source =
      context.sources.add(context.sources.path(model.robot->document.source), std::move(text));
  made.language = model.language;
  made.is_complete = true;
  LinkedModel changed = load_made_model(model.urdf_path, std::move(made), context);
  if (!changed.robot) return std::nullopt;
  return changed;
}

Refusal ReplacedCollisions::change(LinkedModel& model) {
  if (!model.robot) return {};
  auto texts = std::make_unique<CollisionTexts>(
      model, loaded_.sources->text(model.robot->document.source), output_.makes_names);
  std::map<std::size_t, ChosenMass> masses;  // by link
  for (const Use& use : uses_) {
    if (use.model != &model || use.job->made.shapes.empty()) continue;
    texts->replace(use.place, use.job->made.shapes,
                   [&](const std::string& file) { return name_in(model, file); });
    masses.try_emplace(use.place.link, link_mass(model, model.robot->links[use.place.link]));
  }
  if (texts->empty()) return {};
  std::optional<LinkedModel> changed = load(model, texts->text());
  if (changed && texts->follow_contacts(*changed)) changed = load(model, texts->text());
  if (!changed || changed->robot->links.size() != model.robot->links.size())
    return {"cannot be converted: with the new shapes, the robot has more parts than "
            "`--limit urdf-parts` allows",
            Refusal::Cause::options};
  exchange(model, *changed);
  for (const auto& [link, mass] : masses) masses_.emplace(&model.robot->links[link], mass);
  changed_.push_back({&model, model.robot->document.source, std::move(texts), std::move(*changed)});
  return {};
}

void ReplacedCollisions::report() { report_collisions(replaced_, *before_); }

std::vector<Diagnostic> ReplacedCollisions::placed(std::vector<Diagnostic> findings) const {
  const auto original = [&](Span span) {
    for (const Changed& one : changed_) {
      if (one.source == span.source) return one.texts->original(span);
    }
    return span;
  };
  for (Diagnostic& finding : findings) {
    finding.span = original(finding.span);
    for (Label& label : finding.labels) label.span = original(label.span);
    for (Occurrence& other : finding.others) other.span = original(other.span);
    if (!changed_.empty()) finding.fixes.clear();
  }
  return findings;
}

void ReplacedCollisions::restore() {
  if (!before_) return;
  for (Changed& one : changed_) exchange(*one.model, one.others);
  for (Diagnostic& finding : placed(loaded_.found.take())) {
    before_->report(*finding.rule, finding.span, finding.message) = finding;
  }
  loaded_.found = std::move(*before_);
  before_.reset();
  changed_.clear();
}

}  // namespace smurf
