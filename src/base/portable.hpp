// SPDX-License-Identifier: MIT
#pragma once

/// Before a function that a GPU calls too.
#if defined(__CUDACC__)
#define TALUS_PORTABLE __host__ __device__
#else
#define TALUS_PORTABLE
#endif
