// SPDX-License-Identifier: BSD-3-Clause
#include "schema/validator.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <sys/wait.h>

#include "support/temporary_folder.hpp"

namespace smurf::test {

std::optional<std::vector<bool>> validate(const std::vector<Instance>& instances) {
  const TemporaryFolder folder;
  const std::string cases = folder / "cases";
  const std::string verdicts = folder / "verdicts";
  {
    std::ofstream stream(cases, std::ios::binary);
    for (const Instance& one : instances) {
      stream << R"({"schema": ")" << one.schema << R"(", "instance": )" << one.json << "}\n";
    }
  }
  const std::string command =
      "python3 '" SMURF_VALIDATOR "' '" SMURF_SCHEMAS "' '" + cases + "' '" + verdicts + "'";
  const int status = std::system(command.c_str());
  constexpr int kNoPackage = 3;
  constexpr int kNoPython = 127;
  if (WIFEXITED(status) &&
      (WEXITSTATUS(status) == kNoPackage || WEXITSTATUS(status) == kNoPython)) {
    return std::nullopt;
  }
  std::ifstream stream(verdicts);
  std::vector<bool> result;
  for (std::string line; status == 0 && std::getline(stream, line);) {
    result.push_back(line == "1");
  }
  if (result.size() != instances.size()) throw std::runtime_error("failed: " + command);
  return result;
}

}  // namespace smurf::test
