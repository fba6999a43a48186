// SPDX-License-Identifier: MIT
#pragma once
// Work of libraries that may crash, never end or take all memory: done by a child process, which cannot harm this one.

#include <functional>
#include <stdexcept>
#include <string>

#include "base/bytes.hpp"

namespace talus {

/// The child ended before its work did. what() says how, as the end of a sentence: "it crashed (Segmentation fault)".
struct ChildCrash : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Forks, does `work` in the child and returns the bytes that it wrote. The child sees all memory as it is now, and
/// what it changes there is lost; it has one thread and the memory that is free. An Error that `work` throws is thrown
/// here. When SIGINT or SIGTERM arrives meanwhile (base/interrupt.hpp), the child is killed and Error (interrupted)
/// thrown within a tenth of a second: "interrupted while `doing`". Throws ChildCrash when the child crashes, and Error
/// (no_memory) when it finds no memory or cannot be started.
std::vector<std::byte> do_in_child(const std::string& doing, const std::function<void(ByteWriter&)>& work);

/// For such work: ends its process as a crash does after so many seconds of the processor's time, where a library may
/// never return. A busy machine does not shorten them.
void limit_processor_time(double seconds);

/// The same for memory: its process gets so many bytes beside what it has, or what is free if that is less.
void limit_memory(double bytes);

}  // namespace talus
