// SPDX-License-Identifier: BSD-3-Clause
// Sources: CMake install(DIRECTORY), install(FILES); ament_cmake_auto; setuptools data_files.
#include "link/surroundings/installation.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "link/surroundings/python_calls.hpp"

namespace smurf {
namespace {

struct Argument {
  std::string text;
  Span span;
};
struct Command {
  std::string name;
  Span span;
  std::vector<Argument> arguments;
  bool is_conditional = false;
};

/// The commands of a CMakeLists.txt.
std::vector<Command> commands_of(std::string_view text, SourceId source) {
  std::vector<Command> all;
  std::size_t at = 0;
  int conditions = 0;
  const auto span = [&](std::size_t begin, std::size_t end) {
    return Span{source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  };
  const auto skip_comment = [&] {
    if (text.substr(at, 3) == "#[[") {
      at = std::min(text.find("]]", at), text.size());
    } else {
      at = std::min(text.find('\n', at), text.size());
    }
  };
  while (at < text.size()) {
    const char c = text[at];
    if (c == '#') {
      skip_comment();
      continue;
    }
    const bool is_name = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    if (!is_name) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() &&
           (text[at] == '_' || std::isalnum(static_cast<unsigned char>(text[at]))))
      ++at;
    Command command;
    command.name = path::to_lower(text.substr(begin, at - begin));
    command.span = span(begin, at);
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at >= text.size() || text[at] != '(') continue;
    ++at;
    int depth = 1;
    while (at < text.size() && depth > 0) {
      if (is_blank(text[at])) {
        ++at;
      } else if (text[at] == '#') {
        skip_comment();
      } else if (text[at] == '(') {
        ++depth;
        ++at;
      } else if (text[at] == ')') {
        --depth;
        ++at;
      } else if (text[at] == '"') {
        const std::size_t close = std::min(text.find('"', at + 1), text.size());
        command.arguments.push_back(
            {std::string(text.substr(at + 1, close - at - 1)), span(at + 1, close)});
        at = std::min(close + 1, text.size());
      } else {
        const std::size_t first = at;
        while (at < text.size() && !is_blank(text[at]) && text[at] != ')' && text[at] != '(') ++at;
        command.arguments.push_back({std::string(text.substr(first, at - first)), span(first, at)});
      }
    }
    if (is_one_of(command.name, {"endif", "endforeach", "endwhile", "endfunction", "endmacro"})) {
      conditions = std::max(0, conditions - 1);
    }
    command.is_conditional = conditions > 0;
    if (is_one_of(command.name, {"if", "foreach", "while", "function", "macro"})) ++conditions;
    all.push_back(std::move(command));
  }
  return all;
}

bool is_keyword(std::string_view word) {
  return is_one_of(word, {"DESTINATION", "USE_SOURCE_PERMISSIONS", "PATTERN", "REGEX", "EXCLUDE",
                          "FILES_MATCHING", "OPTIONAL", "COMPONENT", "CONFIGURATIONS", "RENAME",
                          "PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "TYPE",
                          "MESSAGE_NEVER", "EXCLUDE_FROM_ALL"});
}

bool has_folder(const SurroundingPackage& package, const std::string& name,
                const FileReader& files) {
  return !files.list(path::join(package.folder, name)).empty();
}

std::string without_slash(std::string text) {
  while (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

class CMake {
 public:
  CMake(SurroundingPackage& package, const FileReader& files) : package_(package), files_(files) {}

  Installation run(std::string_view text, SourceId source) {
    installation_.is_known = true;
    std::string project;
    for (const Command& one : commands_of(text, source)) {
      if (one.name == "project" && !one.arguments.empty()) {
        project = one.arguments.front().text;
        if (!package_.name.empty() && project != package_.name &&
            project.find('$') == std::string::npos && !one.is_conditional) {
          package_.faults.push_back({InstallFault::Kind::project_name, one.arguments.front().span,
                                     project, package_.name});
        }
      } else if (one.name == "install") {
        install(one);
      } else if (one.name == "ament_auto_package") {
        automatic(one);
      } else if (is_one_of(one.name, {"add_subdirectory", "include", "xacro_add_files",
                                      "add_xacro_file", "xacro_install", "ament_export_resources",
                                      "install_directory", "catkin_install_python"})) {
        installation_.is_known = installation_.is_known && one.name == "include" && false;
      } else if (one.name == "set" || one.name == "file") {
        // Values of variables are not followed.
      }
    }
    return std::move(installation_);
  }

 private:
  /// A path below the package; none if it is computed.
  static std::optional<std::string> source_in(std::string text) {
    for (const std::string_view begin :
         {"${CMAKE_CURRENT_SOURCE_DIR}/", "${PROJECT_SOURCE_DIR}/", "${CMAKE_SOURCE_DIR}/", "./"}) {
      if (text.starts_with(begin)) text.erase(0, begin.size());
    }
    if (text.find('$') != std::string::npos) return std::nullopt;
    return text;
  }

  /// A path below the share folder of the package; none for other places.
  std::optional<std::string> destination_in(std::string text) const {
    for (const std::string& begin : {std::string("share/${PROJECT_NAME}"), "share/" + package_.name,
                                     std::string("${CATKIN_PACKAGE_SHARE_DESTINATION}"),
                                     std::string("${CMAKE_INSTALL_PREFIX}/share/${PROJECT_NAME}"),
                                     std::string("${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME}"),
                                     std::string("${CMAKE_INSTALL_DATAROOTDIR}/${PROJECT_NAME}")}) {
      if (!text.starts_with(begin)) continue;
      text.erase(0, begin.size());
      if (!text.empty() && text.front() != '/') return std::nullopt;
      while (text.starts_with('/')) text.erase(0, 1);
      return without_slash(text);
    }
    return std::nullopt;
  }

  void install(const Command& command) {
    if (command.arguments.empty()) return;
    const std::string& form = command.arguments.front().text;
    if (form == "CODE" || form == "SCRIPT") installation_.is_known = false;
    if (form != "DIRECTORY" && form != "FILES" && form != "PROGRAMS") return;
    std::vector<const Argument*> sources;
    const Argument* destination = nullptr;
    bool is_optional = false;
    bool is_source = true;
    for (std::size_t i = 1; i < command.arguments.size(); ++i) {
      const Argument& one = command.arguments[i];
      if (is_keyword(one.text)) {
        is_source = false;
        is_optional = is_optional || one.text == "OPTIONAL";
        if (one.text == "DESTINATION" && i + 1 < command.arguments.size())
          destination = &command.arguments[++i];
      } else if (is_source) {
        sources.push_back(&one);
      }
    }
    if (form == "DIRECTORY") installation_.installs_folders = true;
    if (form == "DIRECTORY" && installation_.place.empty()) {
      installation_.place = sources.empty() ? command.span : sources.front()->span;
    }
    std::optional<std::string> to =
        destination != nullptr ? destination_in(destination->text) : std::nullopt;
    if (destination != nullptr && !to && destination->text.find("${") != std::string::npos &&
        destination->text.find("PROJECT_NAME") == std::string::npos) {
      installation_.is_known = false;
    }
    for (const Argument* one : sources) {
      const auto from = source_in(one->text);
      if (!from) {
        installation_.is_known = false;
        continue;
      }
      const std::string plain = without_slash(*from);
      if (form == "DIRECTORY" && !is_optional && !command.is_conditional && plain != "." &&
          !plain.empty() && !plain.starts_with('/') && !plain.starts_with("..") &&
          !has_folder(package_, plain, files_)) {
        // A folder may be missing because the sources are not whole: only misspellings are sure.
        if (std::string near = similar_folder(plain); !near.empty()) {
          package_.faults.push_back(
              {InstallFault::Kind::no_folder, one->span, plain, std::move(near)});
        }
      }
      if (!to) continue;
      InstalledPart part{plain == "." ? "" : plain, *to, form != "DIRECTORY", one->span};
      const bool is_content = from->ends_with('/') || plain == ".";
      if (part.is_file || !is_content) {
        const std::string last(path::file_name(plain));
        part.to = part.to.empty() ? last : part.to + "/" + last;
      }
      installation_.parts.push_back(std::move(part));
    }
  }

  /// A folder of the package whose name is nearly this one.
  std::string similar_folder(const std::string& name) const {
    const std::string around(path::parent(name));
    const std::vector<std::string> names = files_.list(path::join(package_.folder, around));
    const std::vector<std::string_view> known(names.begin(), names.end());
    constexpr int kMostEdits = 2;
    const auto near = nearest(path::file_name(name), known);
    if (!near || edit_distance(path::file_name(name), *near, kMostEdits) > kMostEdits) return {};
    const std::string folder =
        around.empty() ? std::string(*near) : around + "/" + std::string(*near);
    return has_folder(package_, folder, files_) ? folder : std::string();
  }

  void automatic(const Command& command) {
    bool is_share = false;
    for (const Argument& one : command.arguments) {
      if (one.text == "INSTALL_TO_SHARE") {
        is_share = true;
        installation_.installs_folders = true;
        if (installation_.place.empty()) installation_.place = one.span;
      } else if (is_keyword(one.text) || one.text == "INSTALL_TO_PATH") {
        is_share = false;
      } else if (is_share) {
        const std::string plain = without_slash(one.text);
        installation_.parts.push_back(
            {plain, std::string(path::file_name(plain)), false, one.span});
      }
    }
  }

  SurroundingPackage& package_;
  const FileReader& files_;
  Installation installation_;
};

/// The file names that a pattern with `*` matches in a folder; `**` is not read.
bool fits(std::string_view pattern, std::string_view name) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name;
  if (!name.starts_with(pattern.substr(0, star))) return false;
  const std::string_view rest = pattern.substr(star + 1);
  for (std::size_t at = star; at <= name.size(); ++at) {
    if (fits(rest, name.substr(at))) return true;
  }
  return false;
}

class Setup {
 public:
  Setup(SurroundingPackage& package, const FileReader& files) : package_(package), files_(files) {}

  Installation run(std::string_view text, SourceId source) {
    const python::File file = python::read_file(text, source);
    const python::Value* data = nullptr;
    for (const python::Value& call : file.calls) {
      if (call.callee == "setup") data = call.find("data_files");
    }
    if (data == nullptr || !data->is_list() || file.has_loops) return {};
    installation_.is_known = text.find("os.walk") == std::string_view::npos;
    installation_.place = data->span;
    installation_.installs_folders = true;  // a setup.py lists each of them
    for (const python::Value& entry : data->items) {
      if (!entry.is_list() || entry.items.size() != 2) {
        installation_.is_known = false;
        continue;
      }
      add(entry.items[0], entry.items[1]);
    }
    return std::move(installation_);
  }

 private:
  void add(const python::Value& destination, const python::Value& sources) {
    const std::string* to = destination.literal();
    if (to == nullptr) {
      installation_.is_known = false;
      return;
    }
    const std::string share = "share/" + package_.name;
    const bool is_own = *to == share || to->starts_with(share + "/");
    if (!is_own) {
      const bool is_share = to->starts_with("share/") && !to->starts_with("share/ament_index");
      const std::string other = is_share ? to->substr(6, to->find('/', 6) - 6) : "";
      if (is_share && !other.empty()) {
        package_.faults.push_back({InstallFault::Kind::wrong_package,
                                   destination.pieces.front().span, other, package_.name});
      }
      return;
    }
    const std::string below = *to == share ? "" : without_slash(to->substr(share.size() + 1));
    if (sources.is_list()) {
      for (const python::Value& one : sources.items) {
        if (one.kind == python::Value::Kind::call) glob(one, below);
        if (const std::string* name = one.literal()) file(*name, below, one.span);
        if (!one.is_text() && one.kind != python::Value::Kind::call) installation_.is_known = false;
      }
    } else if (sources.kind == python::Value::Kind::call) {
      glob(sources, below);
    } else {
      installation_.is_known = false;
    }
  }

  void file(const std::string& name, const std::string& below, Span span) {
    const std::string last(path::file_name(name));
    installation_.parts.push_back({name, below.empty() ? last : below + "/" + last, true, span});
  }

  void glob(const python::Value& call, const std::string& below) {
    const std::string* pattern = call.items.empty() ? nullptr : call.items.front().literal();
    const bool is_glob = call.callee == "glob" || call.callee.ends_with(".glob");
    if (!is_glob || pattern == nullptr || pattern->find("**") != std::string::npos ||
        pattern->find_first_of("[?{") != std::string::npos) {
      installation_.is_known = false;
      return;
    }
    const std::string folder(path::parent(*pattern));
    const std::string_view last = path::file_name(*pattern);
    const Span span = call.items.front().pieces.front().span;
    const std::string whole = path::join(package_.folder, folder);
    const std::vector<std::string> names = files_.list(whole);
    bool has_match = false;
    for (const std::string& name : names) {
      if (!fits(last, name) || name.starts_with('.')) continue;
      has_match = true;
      const std::string one = folder.empty() ? name : folder + "/" + name;
      if (!files_.is_file(path::join(whole, name))) {
        if (name != "__pycache__")
          package_.faults.push_back({InstallFault::Kind::glob_folder, span, name, folder});
      } else {
        file(one, below, span);
      }
    }
    if (!has_match && !names.empty()) {
      package_.faults.push_back({InstallFault::Kind::glob_empty, span, *pattern, names.front()});
    }
  }

  SurroundingPackage& package_;
  const FileReader& files_;
  Installation installation_;
};

}  // namespace

std::vector<std::string> Installation::sources_of(std::string_view installed) const {
  std::vector<std::string> found;
  for (const InstalledPart& one : parts) {
    if (one.is_file) {
      if (one.to == installed) found.push_back(one.from);
      continue;
    }
    const bool is_below = one.to.empty() || installed == one.to ||
                          (installed.starts_with(one.to) && installed[one.to.size()] == '/');
    if (!is_below) continue;
    std::string_view rest = installed.substr(std::min(one.to.size(), installed.size()));
    while (rest.starts_with('/')) rest.remove_prefix(1);
    found.push_back(one.from.empty() ? std::string(rest) : path::join(one.from, std::string(rest)));
  }
  return found;
}

bool Installation::has(std::string_view source) const {
  return std::any_of(parts.begin(), parts.end(), [&](const InstalledPart& one) {
    return one.from.empty() || one.from == source ||
           (!one.is_file && source.starts_with(one.from) && source[one.from.size()] == '/');
  });
}

Installation read_cmake(std::string_view text, SourceId source, SurroundingPackage& package,
                        const FileReader& files) {
  return CMake(package, files).run(text, source);
}

Installation read_setup_py(std::string_view text, SourceId source, SurroundingPackage& package,
                           const FileReader& files) {
  return Setup(package, files).run(text, source);
}

}  // namespace smurf
