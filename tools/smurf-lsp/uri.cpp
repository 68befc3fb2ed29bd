// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/uri.hpp"

#include "base/files/path.hpp"
#include "base/files/uri.hpp"

namespace smurf::lsp {
namespace {

constexpr std::string_view kScheme = "file://";

}  // namespace

std::string path_of_uri(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return {};
  uri.remove_prefix(kScheme.size());
  uri = uri.substr(0, uri.find_first_of("?#"));
  const std::size_t slash = uri.find('/');  // after the host, which must be this machine
  if (slash == std::string_view::npos) return {};
  const std::string path = decoded_uri(uri.substr(slash));
  if (path.find('\0') != std::string::npos) return {};
  return path::normalize(path);
}

std::string uri_of_path(std::string_view path) {
  return std::string(kScheme) + encoded_uri(path, "-._~/");
}

}  // namespace smurf::lsp
