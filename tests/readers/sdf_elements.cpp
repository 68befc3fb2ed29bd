// SPDX-License-Identifier: BSD-3-Clause
// The elements of SDF files, and of the SDF that libsdformat makes of URDFs: FILE...
//   file <path>
//   element <tags, separated by /> <value>
//   end                                or: refused
#include <cstdio>
#include <sdf/sdf.hh>
#include <string>

namespace {

void print(const sdf::ElementPtr& element, const std::string& outer) {
  const std::string tags = outer + "/" + element->GetName();
  std::string value = element->GetValue() ? element->GetValue()->GetAsString() : "";
  for (char& c : value) {
    if (c == '\n' || c == '\t') c = ' ';
  }
  std::printf("element\t%s\t%s\n", tags.c_str(), value.c_str());
  for (auto inner = element->GetFirstElement(); inner; inner = inner->GetNextElement()) {
    print(inner, tags);
  }
}

bool print_file(const std::string& path) {
  const sdf::SDFPtr document(new sdf::SDF());
  sdf::init(document);
  sdf::Errors errors;
  if (!sdf::readFile(path, sdf::ParserConfig::GlobalConfig(), document, errors)) return false;
  print(document->Root(), "");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::printf("file\t%s\n", argv[i]);
    std::puts(print_file(argv[i]) ? "end" : "refused");
  }
  return 0;
}
