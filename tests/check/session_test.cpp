// SPDX-License-Identifier: BSD-3-Clause
// Sessions: the findings of a first and a second check, and the files that the second one reads.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>

#include "smurf/check.hpp"
#include "smurf/render.hpp"
#include "support/temporary_folder.hpp"
#include "unit/random.hpp"

namespace fs = std::filesystem;
using namespace smurf;
using test::Random;
using test::TemporaryFolder;

namespace {

const fs::path kFixtures = SMURF_FIXTURES;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// Counts reads of another file reader, by any number of threads at once.
class CountingFiles final : public FileReader {
 public:
  explicit CountingFiles(const FileReader& files) : files_(files) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override {
    {
      const std::lock_guard lock(mutex_);
      read_.push_back(path);
    }
    return files_.read(path, max_bytes);
  }
  bool is_file(const std::string& path) const override { return files_.is_file(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return files_.list(folder);
  }
  std::vector<std::string> take() { return std::exchange(read_, {}); }

 private:
  const FileReader& files_;
  mutable std::mutex mutex_;
  mutable std::vector<std::string> read_;
};

/// All contents of a report.
std::string text_of(const Report& report, const SourceMap& sources) {
  std::string text;
  for (const Diagnostic& one : report.diagnostics) text += render_full(one, sources, {});
  return text + render_json(report.diagnostics, sources, report.summary, {"test", "0"}) +
         std::to_string(report.summary.suppressed);
}

Plan plan_of(const std::vector<std::string>& paths, const std::string& config = {}) {
  Plan plan;
  plan.configs.push_back(config);
  for (const std::string& path : paths) {
    (path.ends_with(".smurfs") ? plan.scenes : plan.models).push_back({path, 0});
  }
  return plan;
}

std::string check(Session& session, const Plan& plan, const CheckSettings& settings = {}) {
  const Report report = session.check(plan, settings);
  return text_of(report, session.sources());
}

/// Typical mistakes in a text: a deleted, doubled or truncated line, a digit, a name.
std::string edited(std::string text, Random& random) {
  if (text.empty()) return "a: 1\n";
  const std::size_t at = random.below(text.size());
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
  switch (random.below(5)) {
  case 0: return text.erase(begin, end - begin);
  case 1: return text.insert(begin, text.substr(begin, end - begin));
  case 2: return text.erase(at, 1);
  case 3: return text.replace(at, 1, 1, static_cast<char>('0' + random.below(10)));
  default: return text.insert(begin, "# smurf-lint: ignore[SML31] because\n");
  }
}

constexpr const char* kUrdf =
    "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"revolute\">"
    "<parent link=\"a\"/><child link=\"b\"/><limit lower=\"2\" upper=\"1\" effort=\"1\" "
    "velocity=\"1\"/></joint></robot>\n";

}  // namespace

TEST_CASE("six lines check a model") {
  Session session;
  const Report report =
      session.check((kFixtures / "rules/SML3101-unknown-joint/bad/model.smurf").string());
  REQUIRE(!report.diagnostics.empty());
  for (const Diagnostic& one : report.diagnostics) CHECK(one.rule->id == "SML3101");
  CHECK(render_concise(report.diagnostics[0], session.sources()).find("SML3101") !=
        std::string::npos);
  CHECK(report.summary.models == 1);
}

TEST_CASE("a path that cannot be read is a finding") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "robots");
  Session session;
  for (const std::string name : {"arm.smruf", "arm.smurf", "s.smurfs"}) {
    const Report report = session.check(folder / name);
    REQUIRE(report.diagnostics.size() == 1);
    CHECK(report.diagnostics[0].rule->id == "SML0001");
    CHECK(report.diagnostics[0].message == "there is no file `" + (folder / name) + "`");
    CHECK(render_concise(report.diagnostics[0], session.sources()).find(name) != std::string::npos);
  }
  const Report report = session.check(folder / "robots");
  REQUIRE(report.diagnostics.size() == 1);
  CHECK(report.diagnostics[0].message == "cannot read `" + (folder / "robots") + "`: is a folder");
}

TEST_CASE("a folder is checked as smurf-lint does it") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    fs::create_directories(fs::path(folder / name).parent_path());
    std::ofstream(folder / name) << text;
  };
  const std::string xacro = "<robot name='r' xmlns:xacro='x'>";
  // Names of includes that no file has, and one of which the folder is not known.
  std::string parts;
  for (int i = 0; i < 20; ++i) {
    parts += "<xacro:include filename='$(find p)/a_name_that_is_long_enough_" + std::to_string(i) +
             ".xacro'/>";
  }
  write("r/urdf/r.urdf.xacro",
        xacro + parts + "<xacro:include filename='$(find p)/urdf/wheel.xacro'/></robot>");
  write("r/urdf/wheel.xacro", xacro + "<link name='w'><mass/></link></robot>");
  write("r/plain.urdf", "<robot name='p'><link name='a'/><link name='b'/></robot>");
  write("r/old/left_out.urdf", "<robot");
  write("r/.smurf-lint.yaml", "exclude: [old]\n");
  Session session;
  const Report report = session.check(folder / "r");
  std::set<std::string> found;
  for (const Diagnostic& one : report.diagnostics) {
    found.insert(std::string(one.rule->id) + " " +
                 fs::path(session.sources().path(one.span.source)).filename().string());
  }
  CHECK(found == std::set<std::string>{"SML1204 plain.urdf", "SML3309 r.urdf.xacro"});
  CHECK(report.problems.empty());
  const std::vector<std::string> paths{folder / "r/plain.urdf", folder / "r/urdf"};
  CHECK(session.check(paths).diagnostics.size() == report.diagnostics.size());
}

TEST_CASE("robots that include what an argument names are checked with their folder") {
  const TemporaryFolder folder;
  for (const std::string name : {"one", "two"}) {
    write(folder / (name + ".urdf.xacro"),
          "<robot name='" + name +
              "' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='more' default=''/>"
              "<link name='a'/><xacro:if value=\"${'$(arg more)' != ''}\">"
              "<xacro:include filename='$(arg more)'/></xacro:if></robot>");
  }
  Session session;
  CHECK(session.check(folder / ".").summary.models == 2);
}

TEST_CASE("a loaded model is checked again with the same result") {
  MemoryFiles files;
  files.add(
      "/r.urdf",
      "<robot name='r'><link name='a'><inertial><mass value='1 kg'/></inertial></link></robot>");
  files.add("/s.smurfs", "entities:\n- {name: e, type: urdf, file: r.urdf, x: 1}\n- 3\n");
  Session session(files);
  const auto check = [&](auto& loaded) {
    const Report report = session.check(loaded);
    return text_of(report, session.sources());
  };
  LoadedModel model = session.load_model("/r.urdf");
  const std::string first = check(model);
  CHECK(first.find("SML1801") != std::string::npos);  // found while reading
  CHECK(check(model) == first);
  LoadedScene scene = session.load_scene("/s.smurfs");
  const std::string of_scene = check(scene);
  CHECK(of_scene.find("SML4001") != std::string::npos);
  CHECK(check(scene) == of_scene);
}

TEST_CASE("targets are applied once") {
  MemoryFiles files;
  files.add("/r.urdf", kUrdf);
  CheckSettings settings;
  settings.selection.targets = {find_target("ros"), find_target("mujoco")};
  CheckSettings without_comments = settings;
  without_comments.heeds_comments = false;
  Session session(files);
  const Report with = session.check(plan_of({"/r.urdf"}), settings);
  REQUIRE(!with.diagnostics.empty());
  for (const Diagnostic& one : with.diagnostics) {
    CHECK(std::set<std::string>(one.notes.begin(), one.notes.end()).size() == one.notes.size());
  }
  const std::string text = text_of(with, session.sources());
  CHECK(text == check(session, plan_of({"/r.urdf"}), without_comments));
}

TEST_CASE("unsaved texts stand in front of files") {
  const TemporaryFolder folder;
  const std::string urdf = folder / "r.urdf";
  write(urdf, "<robot name=\"r\"><link name=\"a\"/></robot>\n");
  const Plan plan = plan_of({urdf});
  Session session;
  CHECK(session.check(plan).diagnostics.empty());
  session.set_text(urdf, "<robot name=\"r\"><link name=\"a\"/><link name=\"a\"/></robot>\n");
  CHECK(session.check(plan).diagnostics.size() == 1);
  session.clear_text(urdf);
  CHECK(session.check(plan).diagnostics.empty());
}

TEST_CASE(
    "models that share a file are checked until it was read too often, on any number of threads") {
  const std::string urdf = "<robot name=\"r\"><link name=\"a\"/></robot>\n";
  MemoryFiles files;
  files.add("/r.urdf", urdf);
  std::vector<std::string> models;
  for (int i = 0; i < 200; ++i) {
    models.push_back("/m" + std::to_string(i) + ".smurf");
    files.add(models.back(), "modelname: r\nfiles: [r.urdf]\n");
  }
  const Plan plan = plan_of(models);
  CheckSettings settings;
  settings.selection.select = {"SML0002"};
  Limits limits;
  limits.rechecked_bytes = 99 * urdf.size();
  std::string first;
  for (const unsigned jobs : {1U, 2U, 7U}) {
    for (const bool remembers : {false, true}) {
      CAPTURE(jobs);
      CAPTURE(remembers);
      settings.jobs = jobs;
      settings.remembers = remembers;
      Session session(files, limits);
      const Report report = session.check(plan, settings);
      REQUIRE(report.diagnostics.size() == 1);
      const Diagnostic& told = report.diagnostics[0];
      CHECK(session.sources().path(told.span.source) == "/m100.smurf");
      CHECK(told.help_text == "raise the limit with `--limit rechecked-bytes=N`");
      CHECK(report.summary.models == 100);
      const std::string text = text_of(report, session.sources());
      if (first.empty()) first = text;
      CHECK(text == first);
      CHECK(check(session, plan, settings) == first);
    }
  }
  limits.rechecked_bytes = 199 * urdf.size();
  Session session(files, limits);
  CHECK(session.check(plan, settings).diagnostics.empty());
}

TEST_CASE("models are checked until there are too many findings, on any number of threads") {
  MemoryFiles files;
  files.add("/r.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>\n");
  std::vector<std::string> models;
  for (int i = 0; i < 9; ++i) {
    models.push_back("/m" + std::to_string(i) + ".smurf");
    files.add(models.back(), "modelname: r\nfiles: [r.urdf]\nmotors: 1\n");
  }
  const Plan plan = plan_of(models);
  CheckSettings settings;
  Session whole(files, {});
  const std::size_t each = whole.check(plan, settings).diagnostics.size() / models.size();
  REQUIRE(each > 0);
  Limits limits;
  limits.all_findings = 3 * each;
  for (const unsigned jobs : {1U, 7U}) {
    CAPTURE(jobs);
    settings.jobs = jobs;
    Session session(files, limits);
    const Report report = session.check(plan, settings);
    REQUIRE(report.diagnostics.size() == 3 * each + 1);
    CHECK(report.summary.models == 3);
    const Diagnostic& told = report.diagnostics.back();
    CHECK(session.sources().path(told.span.source) == "/m3.smurf");
    CHECK(told.help_text == "raise the limit with `--limit all-findings=N`");
  }
  limits.all_findings = models.size() * each;
  Session enough(files, limits);
  CHECK(enough.check(plan, settings).diagnostics.size() == limits.all_findings);
}

TEST_CASE("patterns of paths are compared until there were too many") {
  MemoryFiles files;
  files.add("/.smurf-lint.yaml", "paths: {a*: {ignore: SML}, b*: {ignore: SML}}\n");
  std::vector<std::string> models;
  for (const char* name : {"/a1.urdf", "/a2.urdf", "/a3.urdf"}) {
    models.emplace_back(name);
    files.add(name, kUrdf);
  }
  const Plan plan = plan_of(models, "/.smurf-lint.yaml");
  Limits limits;
  limits.path_checks = 6;
  Session enough(files, limits);
  CHECK(enough.check(plan).diagnostics.empty());
  CHECK(enough.check(plan).diagnostics.empty());
  limits.path_checks = 4;
  Session exhausted(files, limits);
  const Report report = exhausted.check(plan);
  REQUIRE(!report.diagnostics.empty());
  CHECK(report.diagnostics[0].rule->id == "SML0002");
  CHECK(report.diagnostics[0].help_text == "raise the limit with `--limit path-checks=N`");
  CHECK(exhausted.sources().path(report.diagnostics[0].span.source) == "/.smurf-lint.yaml");
  CHECK(exhausted.sources().path(report.diagnostics.back().span.source) == "/a3.urdf");
}

TEST_CASE("what a converter loads is checked as by its path") {
  for (const char* name : {"rules/SML3101-unknown-joint/bad/model.smurf",
                           "rules/SML9103-unused-suppression/bad/model.smurf",
                           "rules/SML5016-degrees-like-radians/bad/scene.smurfs"}) {
    const std::string path = (kFixtures / name).string();
    if (!fs::exists(path)) continue;
    CAPTURE(path);
    Session session;
    // A check by path also reads what surrounds a robot, such as the manifest of its package.
    const auto without_files = [](Report report) {
      report.summary.files = 0;
      return report;
    };
    const std::string whole =
        text_of(without_files(session.check(plan_of({path}))), session.sources());
    Session other;
    if (path.ends_with(".smurfs")) {
      LoadedScene loaded = other.load_scene(path);
      const Report report = without_files(other.check(loaded));
      CHECK(text_of(report, *loaded.sources) == whole);
      CHECK(text_of(report, other.sources()) == whole);
    } else {
      LoadedModel loaded = other.load_model(path);
      const Report report = without_files(other.check(loaded));
      CHECK(text_of(report, *loaded.sources) == whole);
      CHECK(text_of(report, other.sources()) == whole);
    }
  }
}

TEST_CASE("a second check reads only what has changed") {
  const TemporaryFolder folder;
  for (const char* name : {"one", "two"}) {
    fs::copy(kFixtures / "models/arm", fs::path(folder / name), fs::copy_options::recursive);
  }
  const DiskFiles disk;
  CountingFiles files(disk);
  // The files are as new as the test, so only their size shows a further change.
  Session session(files, {}, [](const std::string& path) {
    return FileStamp{stamp_on_disk(path).text, true};
  });
  const Plan plan = plan_of({folder / "one/smurf/arm.smurf", folder / "two/smurf/arm.smurf"});
  const std::string first = check(session, plan);
  CHECK(files.take().size() >= 34);
  CHECK(check(session, plan) == first);
  CHECK(files.take().empty());

  const std::string motors = folder / "one/smurf/arm_motors.yml";
  session.set_text(motors, read(motors) + "- {name: m, type: PID, joint: nowhere}\n");
  CHECK(check(session, plan) != first);
  CHECK(files.take().empty());  // the text is in memory

  session.clear_text(motors);
  write(motors, read(motors) + "# A remark.\n");
  check(session, plan);
  CHECK(files.take() == std::vector<std::string>{motors});

  const std::string mesh = folder / "two/meshes/forearm.obj";
  write(mesh, read(mesh) + "v 0 0 9\n");
  check(session, plan);
  const std::vector<std::string> read_again = files.take();
  CHECK(std::count(read_again.begin(), read_again.end(), mesh) == 1);
  CHECK(std::none_of(read_again.begin(), read_again.end(),
                     [&](const std::string& path) { return path.ends_with(".yml"); }));
}

TEST_CASE("after a cancelled check the next one finds everything") {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  for (int i = 0; i < 20; ++i) paths.push_back(folder / ("r" + std::to_string(i) + ".urdf"));
  const Plan plan = plan_of(paths);
  for (const bool remembers : {false, true}) {
    Session session;
    for (const int after : {0, 1, 10}) {
      for (const std::string& path : paths) {
        const std::string name = "r" + std::to_string(after);
        write(path, "<robot name=\"" + name + "\"><link name=\"a\"/><link name=\"b\"/></robot>");
      }
      CheckSettings settings;
      settings.remembers = remembers;
      std::atomic<int> asked = 0;
      settings.is_cancelled = [&] { return asked++ >= after; };
      const Report part = session.check(plan, settings);
      CHECK(part.summary.models <= static_cast<std::size_t>(after));
      settings.is_cancelled = nullptr;
      Session fresh;
      CHECK(check(session, plan, settings) == check(fresh, plan));
    }
  }
}

TEST_CASE("after random edits a check finds what a new session finds") {
  const TemporaryFolder folder;
  fs::copy(kFixtures / "models/arm", fs::path(folder / "arm"), fs::copy_options::recursive);
  fs::copy(kFixtures / "models/arm_phobos2", fs::path(folder / "two"), fs::copy_options::recursive);
  write(folder / "cell.smurfs",
        "smurfs:\n- {name: one, type: smurf, file: arm/smurf/arm.smurf, anchor: world}\n");
  write(folder / ".smurf-lint.yaml", "ignore: [SML1525]\n");
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / ".")) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_normal().string());
  }
  std::sort(files.begin(), files.end());
  const Plan paths = plan_of(
      {folder / "cell.smurfs", folder / "arm/smurf/arm.smurf", folder / "two/smurf/arm.smurf"},
      folder / ".smurf-lint.yaml");
  Random random;
  Session session;
  std::map<std::string, std::string> unsaved;
  std::set<std::string> seen;
  for (int round = 0; round < 100; ++round) {
    const std::string& file = files[random.below(files.size())];
    const auto known = unsaved.find(file);
    const std::string now = edited(known != unsaved.end() ? known->second : read(file), random);
    if (random.one_in(4)) {
      write(file, now);
    } else if (random.one_in(4)) {
      session.clear_text(file);
      unsaved.erase(file);
    } else {
      session.set_text(file, now);
      unsaved[file] = now;
    }
    CAPTURE(test::seed());
    CAPTURE(round);
    CAPTURE(file);
    Session fresh;
    for (const auto& [path, text] : unsaved) fresh.set_text(path, text);
    const std::string expected = check(fresh, paths);
    REQUIRE(check(session, paths) == expected);
    seen.insert(expected);
  }
  CHECK(seen.size() > 30);
}

TEST_CASE("session: a package that is near is found without reading those behind it") {
  const auto package = [](const std::string& name) {
    return "<package><name>" + name + "</name></package>";
  };
  MemoryFiles memory;
  memory.add("robots/a.xacro", R"(<robot name="a" xmlns:xacro="x">
    <xacro:include filename="$(find parts)/p.xacro"/></robot>)");
  memory.add("one/package.xml", package("one"));
  memory.add("group/parts/package.xml", package("parts"));
  memory.add("group/parts/p.xacro", R"(<robot xmlns:xacro="x"><link name="${1}"/></robot>)");
  memory.add("group/others/package.xml", package("others"));
  CountingFiles files(memory);
  Session session(files, {});
  CheckSettings settings;
  const LoadedExpansion mapped = session.load_xacro("robots/a.xacro", settings);
  CHECK(mapped.expansion.is_complete);
  CHECK_FALSE(mapped.expansion.leaves.empty());
  const std::vector<std::string> read = files.take();
  CHECK(std::count(read.begin(), read.end(), "group/others/package.xml") == 0);
  settings.xacro.needs_origins = false;
  const LoadedExpansion plain = session.load_xacro("robots/a.xacro", settings);
  CHECK(plain.expansion.leaves.empty());
  CHECK(plain.sources->text(plain.expansion.source) ==
        mapped.sources->text(mapped.expansion.source));
}
