# SPDX-License-Identifier: MIT
# Compiler flags shared by every target of the project, as the interface target talus_options.
add_library(talus_options INTERFACE)
target_compile_options(talus_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Werror
  # errno and trapping are never read; both stop the vectoriser. Everything else of IEEE arithmetic stays.
  -fno-math-errno -fno-trapping-math -ffp-contract=fast
  # GCC and clang prefer half of AVX-512's width for loops; the pack uses all of it anyway, so nothing is throttled.
  -mprefer-vector-width=512
  -march=${TALUS_ARCH})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC warns about the ABI of vector types passed by value between translation units; the pack never crosses one.
  # -Wmaybe-uninitialized: GCC 12 warns inside its own avx512fintrin.h (its bug 105593).
  # -Wrestrict: false alarms on `const char* + std::string` at -O3 (its bug 105329).
  target_compile_options(talus_options INTERFACE -Wno-psabi -Wno-maybe-uninitialized -Wno-restrict)
else()
  # clang's -Wconversion includes signedness, GCC's does not; container indices are plain ints here.
  target_compile_options(talus_options INTERFACE -Wno-sign-conversion)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  target_compile_options(talus_options INTERFACE -O3)
endif()
if(TALUS_SANITIZE)
  target_compile_options(talus_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(talus_options INTERFACE -fsanitize=address,undefined)
endif()
if(TALUS_TSAN)
  target_compile_options(talus_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(talus_options INTERFACE -fsanitize=thread)
endif()
