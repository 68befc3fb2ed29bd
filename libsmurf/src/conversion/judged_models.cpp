// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/judged_models.hpp"

#include <algorithm>
#include <utility>

#include "base/files/path.hpp"
#include "conversion/reader_verdict.hpp"
#include "conversion/replaced_collisions.hpp"

namespace smurf {
namespace {

class ModelJudge {
 public:
  ModelJudge(const SceneRequest& request, const FileReader& files, const Limits& limits,
             SceneResult& result)
      : request_(request),
        reader_(*request.format.reader),
        files_(files),
        limits_(limits),
        result_(result) {}

  /// The URDF that the result names: that of the model, or its copy.
  void judge(const LinkedModel& model, FlatModel& flat) {
    if (model.urdf_path.empty()) return;
    ReaderVerdict verdict =
        verdict_on(model.urdf_path, reader_, files_, limits_, request_.packages);
    const bool is_loaded = verdict.refused.empty();
    if (request_.collisions.changes_something()) return replace_collisions(model, flat);
    if (is_loaded && !needs_packages(model)) return add_lost(std::move(verdict.lost));
    if (!request_.model_folder.empty()) {
      UrdfResult copy = copy_of(model, flat);
      if (!copy.refusal) return use(std::move(copy), flat);
    }
    if (is_loaded || request_.force) {
      add_lost(std::move(verdict.refused));
      return add_lost(std::move(verdict.lost));
    }
    refuse(model, verdict.refused);
  }

 private:
  /// Whether the reader would have to be told where packages are. Drake knows those that contain
  /// the URDF, by their package.xml.
  bool needs_packages(const LinkedModel& model) const {
    constexpr std::string_view kScheme = "package://";
    return std::any_of(model.meshes.begin(), model.meshes.end(), [&](const MeshReference& mesh) {
      if (!mesh.exists || !mesh.filename.starts_with(kScheme)) return false;
      const std::size_t slash = mesh.filename.find('/', kScheme.size());
      const std::string inside(mesh.filename, std::min(slash, mesh.filename.size()));
      if (!mesh.path.ends_with(inside)) return true;
      const std::string package = mesh.path.substr(0, mesh.path.size() - inside.size());
      return !model.urdf_path.starts_with(package + "/") ||
             !files_.is_file(path::join(package, "package.xml"));
    });
  }

  /// Names a copy with other shapes, which the reader loads.
  void replace_collisions(const LinkedModel& model, FlatModel& flat) {
    if (result_.refusal) return;
    if (request_.model_folder.empty()) {
      result_.refusal = {
          "cannot be converted: models with the shapes of --collision lie beside the "
          "result; name it with -o FILE",
          Refusal::Cause::options};
      return;
    }
    UrdfResult copy = copy_of(model, flat);
    if (copy.refusal) {
      result_.refusal = std::move(copy.refusal);
      return;
    }
    for (ReplacedCollision& one : copy.collisions) {
      one.place.source = model.robot->document.source;  // the same text
      result_.collisions.push_back(std::move(one));
    }
    use(std::move(copy), flat);
  }

  std::string file_name(const FlatModel& flat) const { return flat.id + ".urdf"; }

  UrdfResult copy_of(const LinkedModel& model, const FlatModel& flat) const {
    Session session(files_, limits_);
    CheckSettings settings;
    settings.is_isolated = true;
    settings.packages = request_.packages;
    LoadedModel loaded = session.load_model(model.urdf_path, settings);
    UrdfRequest wanted{.packages = request_.packages,
                       .reader = &reader_,
                       .mesh_folder = flat.id + "_meshes",
                       .file_name = file_name(flat),
                       .collisions = request_.collisions};
    wanted.collisions.choices = choices_for(request_.collisions, model);
    wanted.collisions.folder = flat.id + "_collisions";
    wanted.options.mesh_uri = MeshUri::relative;
    wanted.options.output_folder = path::join(request_.output_folder, request_.model_folder);
    wanted.options.current_folder = request_.current_folder;
    return convert_to_urdf(session, loaded, wanted);
  }

  void use(UrdfResult copy, FlatModel& flat) {
    const auto in_folder = [&](const std::string& file) {
      return path::join(request_.model_folder, file);
    };
    flat.urdf = in_folder(file_name(flat));
    result_.models.push_back({flat.urdf, std::move(copy.text)});
    for (std::vector<TextFile>* meshes : {&copy.meshes, &copy.new_meshes}) {
      for (TextFile& mesh : *meshes)
        result_.models.push_back({in_folder(mesh.path), std::move(mesh.text)});
    }
    add_lost(std::move(copy.lost_by_reader));
  }

  void add_lost(std::vector<std::string> lost) {
    for (std::string& one : lost) result_.lost_by_reader.push_back(std::move(one));
  }

  void refuse(const LinkedModel& model, const std::vector<std::string>& reasons) {
    if (result_.refusal) return;
    const std::string advice =
        request_.model_folder.empty() ? "; with -o FILE, copies that it loads are written" : "";
    result_.refusal = {"cannot be converted: " + std::string(reader_.title) + " " +
                           first_of(reasons) + " in '" + model.urdf_path + "'" + advice,
                       Refusal::Cause::result, true};
  }

  const SceneRequest& request_;
  const Reader& reader_;
  const FileReader& files_;
  const Limits& limits_;
  SceneResult& result_;
};

}  // namespace

void judge_models(const SceneRequest& request, const LinkedScene& scene,
                  const std::set<std::size_t>& models, const FileReader& files,
                  const Limits& limits, FlatScene& flat, SceneResult& result) {
  ModelJudge judge(request, files, limits, result);
  for (const std::size_t model : models) {
    FlatModel& named = flat.models[model];
    judge.judge(scene.models[to_size(named.source)], named);
  }
}

}  // namespace smurf
