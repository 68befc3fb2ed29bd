// SPDX-License-Identifier: BSD-3-Clause
// Other files: includes, and where `$(find ...)` leads.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "syntax/xml_reader.hpp"
#include "xacro/expander.hpp"
#include "xacro/xacro_cases.hpp"

namespace smurf::xacro {
namespace {

/// Whether a name matches a pattern with '*', '?' and '[...]'.
bool matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0;
  std::size_t star = std::string_view::npos, star_name = 0;
  while (n < name.size()) {
    bool is_match = false;
    std::size_t next = p + 1;
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_name = n;
      continue;
    }
    if (p < pattern.size() && pattern[p] == '[') {
      const std::size_t first = p + 1 + (pattern.substr(p + 1).starts_with('!') ? 1 : 0);
      const std::size_t close = pattern.find(']', first + 1);
      if (close == std::string_view::npos) {
        is_match = name[n] == '[';
      } else {
        for (std::size_t i = first; i < close; ++i) {
          const bool is_range = i + 2 < close && pattern[i + 1] == '-';
          const char last = is_range ? pattern[i + 2] : pattern[i];
          is_match = is_match || (name[n] >= pattern[i] && name[n] <= last);
          if (is_range) i += 2;
        }
        is_match = is_match != (first != p + 1);
        next = close + 1;
      }
    } else if (p < pattern.size()) {
      is_match = pattern[p] == '?' || pattern[p] == name[n];
    }
    if (is_match) {
      p = next;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++star_name;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

bool has_pattern(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return c == '*' || c == '[' || c == '?'; });
}

/// A prefix without a name of its own, which XML parsers refuse; null if there is none.
const xml::Attribute* find_empty_prefix(const xml::Document& document) {
  for (std::size_t i = 0; i < document.elements.size(); ++i) {
    const xml::View view(document, xml::ElementId{static_cast<std::uint32_t>(i)});
    for (const xml::Attribute& one : view.attributes()) {
      if (one.value_span().empty() && one.name().starts_with("xmlns:")) return &one;
    }
  }
  return nullptr;
}

bool is_prefix_declared(const xml::Document& document, Span& place) {
  std::vector<bool> declares(document.elements.size(), false);
  for (std::size_t i = 0; i < document.elements.size(); ++i) {
    const xml::View view(document, xml::ElementId{static_cast<std::uint32_t>(i)});
    const xml::ElementId parent = view.element().parent;
    declares[i] = (parent != xml::kNoElement && declares[static_cast<std::size_t>(parent)]) ||
                  view.attribute("xmlns:xacro") != nullptr;
    if (declares[i]) continue;
    if (view.name().starts_with("xacro:")) place = view.name_span();
    for (const xml::Attribute& one : view.attributes()) {
      if (one.name().starts_with("xacro:")) place = one.name_span();
    }
    if (!place.empty()) return false;
  }
  return true;
}

}  // namespace

std::map<std::string, std::string> installed_folders(std::string_view text) {
  std::map<std::string, std::string> folders;
  std::string plain;  // without comments
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    const std::size_t hash = std::min(text.find('#', at), line_end);
    plain.append(text, at, hash - at).push_back(' ');
    at = line_end + 1;
  }
  const std::string lower = path::to_lower(plain);
  for (std::size_t at = lower.find("install"); at != std::string::npos;
       at = lower.find("install", at + 1)) {
    const std::size_t open = lower.find_first_not_of(kBlanks, at + 7);
    if (open == std::string::npos || lower[open] != '(') continue;
    const std::size_t close = std::min(lower.find(')', open), lower.size());
    at = close;  // commands are not nested
    std::vector<std::string> words;
    const std::string_view inside = std::string_view(plain).substr(open + 1, close - open - 1);
    for (std::size_t word_at = 0; word_at < inside.size();) {
      const std::string_view word = next_word(inside, word_at);
      if (!word.empty()) words.emplace_back(word);
    }
    const auto destination = std::find_if(words.begin(), words.end(), [](const std::string& word) {
      return path::to_lower(word) == "destination";
    });
    if (words.empty() || path::to_lower(words[0]) != "directory" || destination == words.end() ||
        destination + 1 == words.end()) {
      continue;
    }
    std::string target = *(destination + 1);
    constexpr std::string_view kShare = "${CATKIN_PACKAGE_SHARE_DESTINATION}";
    if (target.starts_with(kShare)) {
      target.erase(0, kShare.size());
    } else if (target.starts_with("share/")) {
      const std::size_t slash = target.find('/', 6);
      target = slash == std::string::npos ? "" : target.substr(slash);
    } else {
      continue;
    }
    while (target.starts_with('/')) target.erase(0, 1);
    while (target.ends_with('/')) target.pop_back();
    for (auto word = words.begin() + 1; word != destination; ++word) {
      if ((*word + target).find('$') != std::string::npos) continue;
      const std::string source = path::normalize(*word);
      const std::string name =
          word->ends_with('/') ? target : path::join(target, path::file_name(source));
      const bool is_moved = !name.empty() && name.find('/') == std::string::npos && name != source;
      if (is_moved) folders.emplace(name, source);
    }
  }
  return folders;
}

std::string Expander::whole_path(const std::string& path) {
  if (path::is_absolute(path)) return path;
  const std::string_view folder = path::parent(current_path());
  return folder.empty() ? path : path::join(folder, path);
}

/// The path of a file as it is read and shown: below the folder of its package as it was found.
Expander::PackagePath Expander::package_path(const std::string& written) const {
  PackagePath found{path::normalize(written), {}, {}};
  for (const auto& [absolute, folder] : package_folders_) {
    const std::string& path = found.path;
    const bool is_inside =
        path.size() > absolute.size() && path.starts_with(absolute) && path[absolute.size()] == '/';
    if (!is_inside) continue;
    std::string rest = path.substr(absolute.size() + 1);
    return {path::join(folder, rest), folder, std::move(rest)};
  }
  return found;
}

/// The path of a file that the package does not have, where its CMake file installs it; "" if it is
/// the same.
std::string Expander::path_before_install(const PackagePath& wanted) {
  if (wanted.folder.empty()) return {};
  const std::string name = wanted.rest.substr(0, wanted.rest.find('/'));
  const auto [known, is_new] = packages_.try_emplace(wanted.folder);
  PackageFolder& package = known->second;
  if (is_new) {
    const std::vector<std::string> entries = context_.files.list(wanted.folder);
    meter_.step(entries.size());
    package.entries.insert(entries.begin(), entries.end());
  }
  if (package.entries.contains(name)) return {};
  if (!package.moved) {
    constexpr std::uint64_t kMostBytes = 1U << 20U;
    const FileContent lists =
        context_.files.read(path::join(wanted.folder, "CMakeLists.txt"), kMostBytes);
    meter_.scan(lists.text.size());
    package.moved = installed_folders(lists.text);
  }
  const auto source = package.moved->find(name);
  if (source == package.moved->end()) return {};
  return path::join(path::join(wanted.folder, source->second),
                    wanted.rest.substr(std::min(wanted.rest.size(), name.size() + 1)));
}

namespace {

/// `is_absolute`: the path began with that of a package.
std::string help_to_find(const FileReader& files, const std::string& path, bool is_absolute,
                         std::string_view current, Meter& meter) {
  const std::string_view folder = path::parent(path);
  const std::string name = path::to_lower(path::file_name(path));
  for (const std::string& one : files.list(std::string(folder.empty() ? "." : folder))) {
    meter.step();
    const bool is_other = one != path::file_name(path);
    if (is_other && path::to_lower(one) == name) return "write " + quoted(one) + ": case matters";
  }
  if (is_absolute) return "add the file, or correct the path";
  return "correct the path; it is relative to " + quoted(current);
}

}  // namespace

Expander::File* Expander::open(const std::string& written, Span reference) {
  const PackagePath wanted = package_path(written);
  std::string path = wanted.path;
  if (++files_read_ > context_.limits.xacro_files) {
    fail(rules::sml3312_xacro_limit, reference,
         "more than " + std::to_string(context_.limits.xacro_files) + " files are included",
         raise_limit("xacro-files"));
    return nullptr;
  }
  auto known = files_.find(path);
  if (known != files_.end()) return known->second.get();
  FileContent content = context_.files.read(path, context_.limits.file_bytes);
  const bool is_missing = content.status == ReadStatus::not_found;
  if (std::string other = is_missing ? path_before_install(wanted) : ""; !other.empty()) {
    path = std::move(other);
    known = files_.find(path);
    if (known != files_.end()) return known->second.get();
    content = context_.files.read(path, context_.limits.file_bytes);
  }
  result_.included.insert(path);
  if (content.status != ReadStatus::ok) {
    evaluator_.fail(
        rules::sml3310_xacro_missing_file, "cannot read `" + path + "`: " + content.reason,
        help_to_find(context_.files, path, path::is_absolute(written), current_path(), meter_));
    evaluator_.failure().span = reference;
    evaluator_.failure().is_missing_file = content.status == ReadStatus::not_found;
    if (evaluator_.failure().is_missing_file) evaluator_.failure().missing = path;
    return nullptr;
  }
  auto file = std::make_unique<File>();
  file->path = path;
  file->source = context_.sources.add(path, std::move(content.text));
  return files_.emplace(path, std::move(file)).first->second.get();
}

/// A relative path in a macro or a property is often meant for the folder where it was written.
std::string Expander::help_with_path(const Failure& failure) const {
  const std::string_view here = path::parent(current_path());
  const std::string& writer = context_.sources.path(failure.span.source);
  const bool is_below = here.empty() ? !path::is_absolute(failure.missing)
                                     : failure.missing.starts_with(std::string(here) + "/");
  if (!is_below || path::parent(writer) == here) return failure.help;
  const std::string meant =
      path::join(path::parent(writer), failure.missing.substr(here.empty() ? 0 : here.size() + 1));
  if (!context_.files.is_file(meant)) return failure.help;
  return "write `$(find PACKAGE)/...`: a relative path belongs to the file that is processed, " +
         quoted(current_path()) + ", so " + quoted(meant) + " is not found";
}

bool Expander::parse(File& file) {
  if (file.root != nullptr) return true;
  DiagnosticSink found(context_.limits);
  file.document = parse_xml(context_.sources, file.source, context_.limits, found);
  const bool is_broken = !file.document || found.has_errors();
  for (const Diagnostic& one : found.take()) {
    Diagnostic& diagnostic = context_.sink.report(*one.rule, one.span, one.message);
    diagnostic = one;
    if (is_broken) add_frames(diagnostic);
  }
  if (is_broken) {
    has_failed_ = true;
    return false;
  }
  Span place;
  if (const xml::Attribute* empty = find_empty_prefix(*file.document)) {
    return fail(rules::sml3319_xacro_undeclared_prefix, empty->span(),
                "the prefix of " + quoted(empty->name()) + " is declared with an empty name",
                "write `" + std::string(empty->name()) + "=\"http://www.ros.org/wiki/xacro\"`, " +
                    "or delete it");
  }
  if (!is_prefix_declared(*file.document, place)) {
    return fail(rules::sml3319_xacro_undeclared_prefix, place, "the prefix `xacro` is not declared",
                "add `xmlns:xacro=\"http://www.ros.org/wiki/xacro\"` to the root element");
  }
  NodeTree tree(*file.document, context_.sources.text(file.source), heap_, nodes_);
  file.root = tree.read();
  if (tree.unknown_entity().empty()) return true;
  return fail(rules::sml1001_xml_malformed, tree.unknown_entity(),
              "the entity " + quoted(context_.sources.text(tree.unknown_entity())) +
                  " is not defined",
              "write the character itself");
}

std::vector<std::string> Expander::glob(const std::string& pattern) {
  const PackagePath wanted = package_path(pattern);
  const std::string other = path_before_install(wanted);
  const std::string& path = other.empty() ? wanted.path : other;
  std::vector<std::string> found{path::is_absolute(path) ? "/" : ""};
  for (const std::string_view name : path::names(path)) {
    std::vector<std::string> next;
    for (const std::string& folder : found) {
      if (!has_pattern(name)) {
        next.push_back(path::join(folder, name));
        continue;
      }
      for (const std::string& entry : context_.files.list(folder.empty() ? "." : folder)) {
        if (entry.starts_with('.') && !name.starts_with('.')) continue;
        evaluator_.step(100);
        if (matches(name, entry)) next.push_back(path::join(folder, entry));
      }
    }
    found = std::move(next);
  }
  std::erase_if(found, [&](const std::string& one) { return !context_.files.is_file(one); });
  std::sort(found.begin(), found.end());
  return found;
}

bool Expander::include_file(const Node& in, const std::string& path, Node& out, Scope scope) {
  const NodeAttribute& filename = *in.attribute("filename");
  File* file = open(path, filename.text.whole.use);
  if (file == nullptr) return false;
  const auto repeats = std::count(file_stack_.begin(), file_stack_.end(), file->path);
  if (file_stack_.size() >= context_.limits.include_depth) {
    const bool is_cycle = repeats > 1;
    return fail(is_cycle ? rules::sml3311_xacro_cyclic_include : rules::sml3312_xacro_limit,
                filename.text.whole.use,
                is_cycle ? quoted(file->path) + " includes itself"
                         : "more than " + std::to_string(context_.limits.include_depth) +
                               " files include each other",
                is_cycle ? "delete the include, or make it depend on a condition"
                         : raise_limit("include-depth"));
  }
  file_stack_.push_back(file->path);
  Frame frame;
  frame.kind = Frame::Kind::include;
  frame.parent = frame_;
  frame.call = in.tag_span;
  frame.name = file->path;
  const FrameId outer = frame_;
  result_.frames.push_back(std::move(frame));
  frame_ = FrameId{static_cast<std::uint32_t>(result_.frames.size() - 1)};
  if (!parse(*file)) return false;
  Node& holder = new_node(NodeKind::element);
  if (!evaluate(*file->root, holder, scope)) return false;
  frame_ = outer;
  file_stack_.pop_back();
  set_xmlns(out, holder);
  out.children.insert(out.children.end(), holder.children.begin(), holder.children.end());
  return true;
}

bool Expander::include(const Node& in, Node& out, Scope scope) {
  const NodeAttribute* filename = required(in, "filename");
  if (filename == nullptr) return false;
  warn_of_others(in, {"filename", "ns", "optional"});
  MacroTable* macros = &scope.macros;
  Table* symbols = &scope.symbols;
  const NodeAttribute* ns = in.attribute("ns");
  if (ns != nullptr && !ns->text.value.empty()) {
    const Value name = evaluate_text(*ns, scope.symbols);
    if (name.is_failed()) return report();
    const std::string_view key = heap_.keep(evaluator_.string_of(name));
    if (evaluator_.has_failed()) return report();
    macros = &macro_tables_.emplace_back();
    symbols = &tables_.emplace_back(scope.symbols, true);
    scope.macros.set(key, {nullptr, macros});
    Value space;
    space.kind = Kind::name_space;
    space.table = symbols;
    scope.symbols.set(key, space);
  }
  bool is_optional = false;
  if (const NodeAttribute* optional = in.attribute("optional")) {
    const auto truth = truth_of(heap_.text(std::string(optional->text.value)));
    if (!truth) {
      return fail(rules::sml3314_xacro_condition, optional->text.whole.use,
                  quoted(optional->text.value) + " is no truth value", "write `true` or `false`");
    }
    is_optional = *truth;
  }
  const Value written = evaluate_text(*filename, scope.symbols);
  if (written.is_failed()) return report();
  if (!written.is_text()) {
    return fail(rules::sml3310_xacro_missing_file, filename->text.whole.use,
                "the name of the file is " + std::string(kind_name(written)), "write a path");
  }
  if (written.text->empty()) {
    evaluator_.fail(rules::sml3310_xacro_missing_file, "the name of the included file is empty",
                    "write a path, or give the argument that names the file a value: `NAME:=PATH`");
    evaluator_.failure().span = filename->text.whole.use;
    evaluator_.failure().which = &kEmptyFileName;
    return report();
  }
  const std::string path = whole_path(*written.text);
  const bool is_pattern = has_pattern(path);
  const std::vector<std::string> paths = is_pattern ? glob(path) : std::vector<std::string>{path};
  if (evaluator_.has_failed()) {
    evaluator_.failure().span = filename->text.whole.use;
    return report();
  }
  if (paths.empty() && is_first_at(filename->text.whole.use)) {
    context_.sink
        .report(rules::sml3404_xacro_no_match, filename->text.whole.use,
                "no file matches " + quoted(path))
        .help("correct the pattern");
  }
  Node& included = new_node(NodeKind::element);
  for (const std::string& one : paths) {
    const FrameId frame = frame_;
    const std::size_t files = file_stack_.size();
    optional_includes_ += is_optional ? 1 : 0;
    const bool is_done = include_file(in, one, included, {*macros, *symbols});
    optional_includes_ -= is_optional ? 1 : 0;
    if (is_done) continue;
    // Also a file that the optional one needs.
    const bool is_ignored = is_optional && !has_failed_ && evaluator_.failure().is_missing_file;
    if (!is_ignored) return report();
    evaluator_.take_failure();
    frame_ = frame;
    file_stack_.resize(files);
  }
  remove_comments(out);
  set_xmlns(out, included);
  out.children.insert(out.children.end(), included.children.begin(), included.children.end());
  return true;
}

}  // namespace smurf::xacro
