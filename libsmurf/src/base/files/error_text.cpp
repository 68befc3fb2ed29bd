// SPDX-License-Identifier: BSD-3-Clause
// Why the system refused a file, in the words of Linux on every system: reports are compared.
#include <cerrno>
#include <system_error>

#include "base/files/system.hpp"

namespace smurf::sys {

std::string error_text(int error) {
  // The libraries of Windows and WebAssembly have other words for these.
  switch (error) {
  case EBUSY: return "Device or resource busy";
  case EIO: return "Input/output error";
  case ELOOP: return "Too many levels of symbolic links";
  case EMFILE: return "Too many open files";
  case ENAMETOOLONG: return "File name too long";
  case ENOMEM: return "Cannot allocate memory";
  case ENXIO: return "No such device or address";
  case EXDEV: return "Invalid cross-device link";
  default: return std::generic_category().message(error);
  }
}

}  // namespace smurf::sys
