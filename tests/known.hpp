#pragma once

#include <cstddef>
#include <span>

#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#endif

namespace kfast::test {

/// Ends the program if some of it has never been written, where the memory sanitizer looks. Of itself it
/// looks at what decides something, not at what is handed over, such as pixels.
template <class T, std::size_t size>
void demand_known([[maybe_unused]] std::span<T, size> written)
{
#if __has_feature(memory_sanitizer)
    __msan_check_mem_is_initialized(written.data(), written.size_bytes());
#endif
}

}
