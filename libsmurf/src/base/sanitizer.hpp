// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// 1 in a build with AddressSanitizer, which is several times slower and reserves more memory than
// any useful limit allows.
#if defined(__SANITIZE_ADDRESS__)
#define SMURF_HAS_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#define SMURF_HAS_ADDRESS_SANITIZER __has_feature(address_sanitizer)
#else
#define SMURF_HAS_ADDRESS_SANITIZER 0
#endif
