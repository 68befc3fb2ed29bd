// SPDX-License-Identifier: BSD-3-Clause
// A table of poses, for shells, spreadsheets and spawn scripts.
#include "base/numbers/numbers.hpp"
#include "base/text/misread.hpp"
#include "base/text/utf8.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::scene_tsv_file {
namespace {

/// Escapes tabs and line ends, which would break the table, and other control characters. A leading
/// backslash prevents a spreadsheet from reading a name as a formula. The first character of a
/// build server's command is escaped, so that names stay exact.
std::string cell(std::string_view text) {
  constexpr std::string_view kFormula = "=+-@";
  std::string escaped;
  if (!text.empty() && kFormula.find(text.front()) != std::string_view::npos) escaped = "\\";
  for (std::size_t at = 0; at < text.size();) {
    const utf8::CodePoint point = utf8::decode(text.substr(at));
    switch (point.value) {
    case '\\': escaped += "\\\\"; break;
    case '\t': escaped += "\\t"; break;
    case '\n': escaped += "\\n"; break;
    case '\r': escaped += "\\r"; break;
    case 0xFFFD: escaped += utf8::kReplacement; break;  // an invalid byte
    default:
      if (utf8::is_control(point.value) || is_misread(text, at, point.value)) {
        utf8::append_escape(escaped, point.value);
      } else {
        escaped += text.substr(at, point.size);
      }
    }
    at += point.size;
  }
  return escaped;
}

std::string attachment(const FlatAttachment& attachment) {
  switch (attachment.kind) {
  case Attachment::Kind::none: return "free";
  case Attachment::Kind::world: return "world";
  case Attachment::Kind::link: break;
  }
  return cell(attachment.instance + "::" + attachment.link);
}

std::string row(const FlatInstance& instance, const FlatScene& scene) {
  const FlatModel* model = instance.model ? &scene.models[*instance.model] : nullptr;
  std::string text = cell(instance.path) + '\t' + cell(instance.type) + '\t' +
                     (model != nullptr ? cell(model->id) : "") + '\t' +
                     cell(model != nullptr ? model->urdf : instance.file);
  const auto add = [&](double value) { text += '\t' + format_number(value); };
  for (const double component : instance.X_WE->position) add(component);
  const Quaternion& q = instance.X_WE->orientation;
  for (const double component : {q.w, q.x, q.y, q.z}) add(component);
  text += '\t' + attachment(instance.anchor) + '\t';
  bool is_first = true;
  for (const auto& [joint, position] : instance.joint_positions) {
    text += (is_first ? "" : ",") + cell(joint) + "=" + format_number(position);
    is_first = false;
  }
  return text + '\n';
}

std::string write(const SceneExport& scene) {
  std::string text =
      "path\ttype\tmodel\tfile\tpx\tpy\tpz\tqw\tqx\tqy\tqz\tattachment\tjoint_positions\n";
  for (const FlatInstance& instance : scene.flat.instances) {
    if (instance.X_WE) text += row(instance, scene.flat);
  }
  return text;
}

}  // namespace

extern constinit const SceneFormat scene_tsv{
    .name = "tsv", .help = "a table of poses, one line per instance", .write = write};

}  // namespace smurf::scene_tsv_file
