// SPDX-License-Identifier: BSD-3-Clause
// What libsdformat says.
//   sdf_answers --descriptions    the elements and attributes that it knows, one a line, with tabs
//   between:
//     element PATH REQUIRED TYPE MIN MAX      attribute PATH/@NAME REQUIRED TYPE MIN MAX
//   sdf_answers FILE...           for each file, the first error that it reports, or "loads":
//     FILE ANSWER
#include <cstdint>
#include <cstdio>
#include <sdf/sdf.hh>
#include <string>

namespace {

/// Ends the recursion in elements that may contain themselves; no other element is as deep.
constexpr int kDeepest = 12;

void print(const char* what, const std::string& path, const std::string& is_required,
           const sdf::ParamPtr& value) {
  std::printf("%s\t%s\t%s\t%s\t%s\t%s\n", what, path.c_str(), is_required.c_str(),
              value ? value->GetTypeName().c_str() : "",
              value ? value->GetMinValueAsString().value_or("").c_str() : "",
              value ? value->GetMaxValueAsString().value_or("").c_str() : "");
}

/// Elements are described by reference, and a model has models inside, so a path has each name
/// once.
void describe(const sdf::ElementPtr& element, const std::string& outer, int depth) {
  const std::string path = outer + "/" + element->GetName();
  print("element", path, element->GetRequired(), element->GetValue());
  for (std::size_t i = 0; i < element->GetAttributeCount(); ++i) {
    const sdf::ParamPtr one = element->GetAttribute(static_cast<unsigned>(i));
    print("attribute", path + "/@" + one->GetKey(), one->GetRequired() ? "1" : "0", one);
  }
  if (depth > kDeepest) return;
  for (std::size_t i = 0; i < element->GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr inner = element->GetElementDescription(static_cast<unsigned>(i));
    if ((path + "/").find("/" + inner->GetName() + "/") == std::string::npos)
      describe(inner, path, depth + 1);
  }
}

std::string answer(const std::string& path) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(path);
  if (errors.empty()) return "loads";
  std::string said = errors.front().Message();
  for (char& c : said) {
    if (c == '\n' || c == '\t') c = ' ';
  }
  return said;
}

}  // namespace

int main(int argc, char** argv) {
  sdf::Console::Instance()->SetQuiet(true);
  if (argc == 2 && argv[1] == std::string("--descriptions")) {
    const sdf::SDFPtr document(new sdf::SDF());
    sdf::init(document);
    describe(document->Root(), "", 0);
    return 0;
  }
  for (int i = 1; i < argc; ++i) {
    std::printf("%s\t%s\n", argv[i], answer(argv[i]).c_str());
    std::fflush(stdout);  // it ends the process for some files
  }
  return 0;
}
