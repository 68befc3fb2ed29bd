// SPDX-License-Identifier: BSD-3-Clause
// Checking and loading. A function with a separate session lets other Python threads run.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/companions.hpp"
#include "smurf/each.hpp"

namespace smurf::python {
namespace {

constexpr const char* kSettings =
    "\n\nKeyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no "
    "configuration), `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict "
    "from rules to \"error\", \"warning\" or \"info\"), `targets` (names of readers), `packages` "
    "(a dict from names to folders), `args` (a dict with the arguments of a .xacro), `xacro_env` "
    "(names of variables that a .xacro may read), `baseline` (a path), `no_ignores`, "
    "`allow_outside` (read what models name wherever it lies), "
    "`max_seconds` (of processor time for each file; 0: no end), `jobs`.";

/// Lets other threads of Python run.
class OthersMayRun {
 public:
  OthersMayRun() : state_(PyEval_SaveThread()) {}
  ~OthersMayRun() {
    // When Python has ended meanwhile, it unwinds this thread as a C program would. What is on its
    // stack must not be released without the lock: the thread sleeps until the process is gone.
    try {
      PyEval_RestoreThread(state_);
    } catch (...) {
      while (true) std::this_thread::sleep_for(std::chrono::hours(1));
    }
  }
  OthersMayRun(const OthersMayRun&) = delete;
  OthersMayRun& operator=(const OthersMayRun&) = delete;

 private:
  PyThreadState* state_;
};

/// Runs with the lock of Python, or without it where nothing else can use the session.
template <class Run>
auto run_alone(bool is_shared, const Run& run) {
  if (is_shared) return run();
  const OthersMayRun others_may_run;
  return run();
}

py::object check(Session& session, const std::vector<std::string>& paths,
                 const CheckSettings& settings, bool is_shared) {
  Report report = run_alone(is_shared, [&] {
    return paths.size() == 1 ? session.check(paths.front(), settings)
                             : session.check(paths, settings);
  });
  return to_report(std::move(report), session.sources());
}

bool is_path(const py::handle& value) {
  return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
         py::hasattr(value, "__fspath__");
}

/// A path, or an iterable of them.
std::vector<std::string> from_paths(const py::handle& value) {
  if (is_path(value)) return {from_path(value)};
  std::vector<std::string> paths;
  for (const py::handle one : py::iter(value)) paths.push_back(from_path(one));
  if (paths.empty()) throw py::value_error("there is no path to check");
  return paths;
}

/// What is loaded for a path that may be that of an archive.
std::string main_file(const std::string& path, const Session& session) {
  if (!is_archive(path)) return path;
  const DiskFiles disk;  // the session has not been asked for anything that it could let be read
  const ArchiveFiles archives(disk, session.limits());
  ArchivedMain main = main_file_of_archive(path, archives);
  if (main.path.empty()) raise_error("cannot read '" + path + "': it " + main.reason, py::list());
  return std::move(main.path);
}

bool has_content(const LinkedModel& model) {
  return model.robot ||
         std::any_of(model.files.begin(), model.files.end(),
                     [](const ModelFile& file) { return file.document.has_value(); });
}

bool has_content(const LinkedScene& scene) {
  return std::any_of(scene.scenes.begin(), scene.scenes.end(),
                     [](const SceneFile& file) { return file.document || file.drawing; }) ||
         std::any_of(scene.models.begin(), scene.models.end(),
                     [](const LinkedModel& model) { return has_content(model); });
}

template <class Loaded>
[[noreturn]] void raise_unreadable(const std::string& path, Session& session, Loaded& loaded) {
  const FileContent content = session.files().read(path, session.limits().file_bytes);
  const bool is_read = content.status == ReadStatus::ok;
  raise_error("cannot read '" + path + "'" + (is_read ? "" : ": " + content.reason),
              to_findings(session.settle(loaded, loaded.found.take()), session.loaded_sources()));
}

py::object load_model(const std::shared_ptr<Session>& session, const std::string& path,
                      const CheckSettings& settings, bool is_shared, const py::object& recipe) {
  const std::string main = main_file(path, *session);
  const InputKind kind = input_kind(main);
  if (kind == InputKind::scene || kind == InputKind::drawing) {
    throw py::value_error(
        py::str("{!r} is a scene, which load_scene() loads").format(to_path(path)));
  }
  auto owner = std::make_shared<Owner>(Owner{session, settings, recipe});
  run_alone(is_shared, [&] { owner->model.emplace(session->load_model(main, settings)); });
  if (!has_content(owner->model->model)) raise_unreadable(main, *session, *owner->model);
  const LinkedModel* model = &owner->model->model;
  return py::cast(Ref<LinkedModel>{std::move(owner), model});
}

/// Loads with a separate session, which lets other threads run: network drives are slow.
template <class Load>
auto with_own_session(const char* name, const Load& load) {
  return [name, load](const py::object& path, const py::kwargs& settings) {
    return load(std::make_shared<Session>(), from_path(path), settings_of(settings), false,
                py::make_tuple(name, path, settings));
  };
}
template <class Load>
auto with_session(const Load& load) {
  return [load](const std::shared_ptr<Session>& self, const py::object& path,
                const py::kwargs& settings) {
    return load(self, from_path(path), settings_of(settings), true, py::object());
  };
}

py::object check_alone(const py::object& paths, const py::kwargs& settings) {
  Session session;
  return check(session, from_paths(paths), settings_of(settings), false);
}

py::object check_in_session(const std::shared_ptr<Session>& self, const py::object& paths,
                            const py::kwargs& settings) {
  return check(*self, from_paths(paths), settings_of(settings), true);
}

/// The robots and scenes of files and folders, each of which is checked by itself.
struct EachPlan {
  Plan plan;
  std::optional<EachChecks> checks;
};

std::shared_ptr<EachPlan> plan_each(const py::object& paths, const py::kwargs& keywords) {
  auto each = std::make_shared<EachPlan>();
  const CheckSettings settings = settings_of(keywords);
  const std::vector<std::string> inputs = from_paths(paths);
  run_alone(false, [&] {
    Session session;
    each->plan = session.plan(inputs, settings);
  });
  if (!each->plan.problems.empty()) raise_error(each->plan.problems.front(), py::list());
  each->checks.emplace(each->plan, settings, Limits{});
  return each;
}

/// The check of one of them.
struct OneOfPlan {
  std::shared_ptr<EachPlan> plan;
  std::optional<EachCheck> check;
  std::optional<RobotSize> size;
};

std::shared_ptr<OneOfPlan> one_of(const std::shared_ptr<EachPlan>& plan, std::size_t index) {
  auto one = std::make_shared<OneOfPlan>(OneOfPlan{plan, std::nullopt, std::nullopt});
  run_alone(false, [&] { one->check.emplace(plan->checks->of(index)); });
  return one;
}

/// None for a part of robots that was found in a folder.
py::object check_one(OneOfPlan& one) {
  Report report = run_alone(false, [&] { return one.check->check(); });
  one.size = report.size;
  if (one.check->is_only_part()) return py::none();
  return to_report(std::move(report), one.check->sources());
}

void bind_each(py::module_& module) {
  py::class_<OneOfPlan, std::shared_ptr<OneOfPlan>>(module, "_OneOfPlan")
      .def("known",
           [](OneOfPlan& self) -> py::object {
             const auto known = run_alone(false, [&] { return self.check->known(); });
             if (!known) return py::none();
             return py::bytes(*known);
           })
      .def("check", &check_one)
      .def("keep",
           [](OneOfPlan& self, const std::string& answer) {
             run_alone(false, [&] { self.check->keep(answer); });
           })
      .def("digest", [](const OneOfPlan& self) { return self.check->digest(); })
      .def("size", [](const OneOfPlan& self) -> py::object {
        if (!self.size) return py::none();
        return py::make_tuple(self.size->links, self.size->mass);
      });
  py::class_<EachPlan, std::shared_ptr<EachPlan>>(module, "_EachPlan")
      .def("__len__", [](const EachPlan& self) { return self.checks->files().size(); })
      .def("path",
           [](const EachPlan& self, std::size_t index) {
             return to_path(self.checks->files().at(index).planned->path);
           })
      .def("of", &one_of)
      .def("use_cache",
           [](EachPlan& self, const py::object& folder, const std::string& form) {
             self.checks->use_cache(from_path(folder), form);
           })
      .def("cache_problem", [](const EachPlan& self) { return self.checks->cache_problem(); });
  module.def("_plan_each", &plan_each);
}

std::string text_or_bytes(const py::object& text) {
  return py::isinstance<py::bytes>(text) ? std::string(py::reinterpret_borrow<py::bytes>(text))
                                         : from_text(text, "text");
}

/// A text that has to be expanded first.
bool is_xacro_text(std::string_view text) {
  return text.find("xmlns:xacro") != std::string_view::npos;
}

py::object parse_urdf(const py::object& text, const py::object& filename,
                      const py::kwargs& settings) {
  const std::string urdf = text_or_bytes(text);
  std::string name = is_xacro_text(urdf) ? "robot.urdf.xacro" : "robot.urdf";
  if (!filename.is_none()) name = from_path(filename);
  auto session = std::make_shared<Session>();
  session->set_text(name, urdf);
  const py::dict all = settings.attr("copy")();
  if (!filename.is_none()) all["filename"] = filename;
  return load_model(session, name, settings_of(settings), false,
                    py::make_tuple("parse_urdf", text, all));
}

constexpr const char* kCheckDoc =
    "Checks a model, URDF, xacro, scene or annotation file with all that it loads, or all such files "
    "in a folder, or an iterable of files and folders, and returns a smurf.Report. Raises "
    "smurf.Error when a path cannot be read.";
constexpr const char* kParseDoc =
    "Loads the text of a URDF (str or bytes) and returns a smurf.Model; the text of a xacro file is "
    "expanded. Relative paths in it start at the folder of `filename`, or at the current folder.";
constexpr const char* kModelDoc =
    "Loads a .smurf, a .urdf, a .xacro, an annotation file or an archive (.zsmurf), and returns a "
    "smurf.Model. What is wrong in it is told by its check(); smurf.Error is raised when there is "
    "nothing that could be read.";
constexpr const char* kSceneDoc =
    "Loads a .smurfs, a .smurfa, a drawing (.svg) or an archive with all models and scenes it "
    "names, and returns a smurf.Scene; a .smurf or .urdf counts as a scene of one entity. Raises "
    "smurf.Error as load_model() does.";

}  // namespace

py::object load_scene(const std::shared_ptr<Session>& session, const std::string& path,
                      const CheckSettings& settings, bool is_shared, const py::object& recipe) {
  const std::string main = main_file(path, *session);
  auto owner = std::make_shared<Owner>(Owner{session, settings, recipe});
  run_alone(is_shared, [&] { owner->scene.emplace(session->load_scene(main, settings)); });
  if (!has_content(owner->scene->scene)) raise_unreadable(main, *session, *owner->scene);
  const LinkedScene* scene = &owner->scene->scene;
  return py::cast(Ref<LinkedScene>{std::move(owner), scene});
}

void bind_session(py::module_& module) {
  const auto doc = [](const char* what) { return std::string(what) + kSettings; };
  const std::string check_doc = doc(kCheckDoc);
  const std::string model_doc = doc(kModelDoc);
  const std::string scene_doc = doc(kSceneDoc);
  const std::string parse_doc = doc(kParseDoc);
  module.def("check", &check_alone, py::arg("path"), check_doc.c_str());
  module.def("load_model", with_own_session("load_model", load_model), py::arg("path"),
             model_doc.c_str());
  module.def("load_scene", with_own_session("load_scene", load_scene), py::arg("path"),
             scene_doc.c_str());
  module.def("parse_urdf", &parse_urdf, py::arg("text"), py::arg("filename") = py::none(),
             parse_doc.c_str());
  bind_each(module);
  py::class_<Session, std::shared_ptr<Session>>(
      module, "Session",
      "Files on the disk with unsaved texts in front of them, for editors: a second check reads "
      "again only what has changed.")
      .def(py::init<>())
      .def(
          "set_text",
          [](const std::shared_ptr<Session>& self, const py::object& path, const py::object& text) {
            self->set_text(from_path(path), text_or_bytes(text));
          },
          py::arg("path"), py::arg("text"), "Puts a str or bytes in the place of a file.")
      .def(
          "clear_text",
          [](const std::shared_ptr<Session>& self, const py::object& path) {
            self->clear_text(from_path(path));
          },
          py::arg("path"), "What is on the disk counts again.")
      .def("check", &check_in_session, py::arg("path"), check_doc.c_str())
      .def("load_model", with_session(load_model), py::arg("path"), model_doc.c_str())
      .def("load_scene", with_session(load_scene), py::arg("path"), scene_doc.c_str());
}

}  // namespace smurf::python
