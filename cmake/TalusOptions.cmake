# SPDX-License-Identifier: MIT
# How the sources are compiled: headers that are compiled once, the cache, and the flags of every target.

# Headers from outside that most sources include. Those of the project would renew every source with each change, and cost more to load
# than they save.
set(TALUS_PRECOMPILED <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <numeric> <optional> <set> <sstream>
  <string> <variant> <vector> <fmt/format.h>)
# The engine's vector arithmetic besides.
set(TALUS_PRECOMPILED_ENGINE ${TALUS_PRECOMPILED})
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND TALUS_PRECOMPILED_ENGINE <immintrin.h>)
endif()

# A launcher that was asked for comes before ccache. Precompiled headers are cached only with these words.
find_program(TALUS_CCACHE ccache)
if(TALUS_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${TALUS_CCACHE})
endif()

# Compiler flags shared by every target of the project, as the interface target talus_options.
add_library(talus_options INTERFACE)
target_compile_options(talus_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror
  # errno and trapping are never read; both stop the vectoriser. Everything else of IEEE arithmetic stays.
  -fno-math-errno -fno-trapping-math -ffp-contract=fast
  # GCC and clang prefer half of AVX-512's width for loops; the pack uses all of it anyway, so nothing is throttled.
  $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-mprefer-vector-width=512>
  -march=${TALUS_ARCH})
# Eigen would share products among threads by itself, and change their last bits with the number of threads.
target_compile_definitions(talus_options INTERFACE EIGEN_DONT_PARALLELIZE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC warns about the ABI of vector types passed by value between translation units; the pack never crosses one.
  # -Wmaybe-uninitialized: GCC 12 warns inside its own avx512fintrin.h (its bug 105593).
  # -Wrestrict: false alarms on `const char* + std::string` at -O3 (its bug 105329). -Warray-bounds, -Wstringop-*: the same kind inside
  # std::string, which GCC no longer knows to be a system's where it is precompiled. The sanitizers find true ones.
  # -fpch-preprocess: ccache needs it. ggc-…: the compiler collects its garbage later, which was an eighth of its time on large sources.
  target_compile_options(talus_options INTERFACE -Wno-psabi -Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow
    -Wno-stringop-overread -fpch-preprocess --param=ggc-min-heapsize=500000 --param=ggc-min-expand=200)
else()
  # clang's -Wconversion includes signedness, GCC's does not; container indices are plain ints here. -Wno-psabi: as for GCC.
  target_compile_options(talus_options INTERFACE -Wno-sign-conversion -Wno-psabi)
endif()
if(TALUS_SANITIZE)
  target_compile_options(talus_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(talus_options INTERFACE -fsanitize=address,undefined)
endif()
if(TALUS_TSAN)
  target_compile_options(talus_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(talus_options INTERFACE -fsanitize=thread)
endif()

# For sources in which nothing is calculated, and which sanitizers make many times as long. Multiplications and additions are fused as they are elsewhere
# (-fexpensive-optimizations), so that a number in a text has the same last digit.
add_library(talus_text_options INTERFACE)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  target_compile_options(talus_text_options INTERFACE -O1)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # -Wno-uninitialized: GCC's bug 105593 again, at -O1
    target_compile_options(talus_text_options INTERFACE -fexpensive-optimizations -Wno-uninitialized)
  endif()
else()
  target_compile_options(talus_text_options INTERFACE -O0)
endif()

# For targets that compile several sources at a time, after the options above: a local name of one source may be that of a parameter in
# another, and -Wshadow is for sources that stand alone (tools/lint.sh).
add_library(talus_unity_options INTERFACE)
if(TALUS_UNITY)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(talus_unity_options INTERFACE -Wno-shadow -Wshadow=local -Wno-subobject-linkage)
  else()
    target_compile_options(talus_unity_options INTERFACE -Wno-shadow)
  endif()
endif()

# A fuzzer watches what reads bytes, and not the kernels, which would be twice as slow.
if(TALUS_FUZZ)
  target_compile_options(talus_text_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>)
endif()

# For modules: a missing symbol is found when they are linked, not when they are loaded. A sanitizer's symbols come with the program.
add_library(talus_module_options INTERFACE)
if(NOT TALUS_SANITIZE AND NOT TALUS_TSAN)
  target_link_options(talus_module_options INTERFACE -Wl,--no-undefined)
endif()

# For tests that read the output of the program and the library.
add_library(talus_reading_options INTERFACE)
target_compile_options(talus_reading_options INTERFACE -O0)
