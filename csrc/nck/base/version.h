// SPDX-License-Identifier: MIT
// The version of this interface. Before 1.0 a minor version may change it.
#ifndef NCK_BASE_VERSION_H
#define NCK_BASE_VERSION_H

// By its parts.
#define NCK_VERSION_MAJOR 0
#define NCK_VERSION_MINOR 1
#define NCK_VERSION_PATCH 0

// For comparisons: 1.2.3 is 10203.
#define NCK_VERSION (NCK_VERSION_MAJOR * 10000 + NCK_VERSION_MINOR * 100 + NCK_VERSION_PATCH)

#endif
