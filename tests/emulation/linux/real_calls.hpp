#pragma once

#include <cstdio>
#include <dlfcn.h>

namespace kfast::test {

/// The function of that name that stands behind the one in this library.
template <class F>
F* real(const char* name)
{
    return reinterpret_cast<F*>(::dlsym(RTLD_NEXT, name));
}

inline std::FILE* real_fopen(const char* path, const char* mode)
{
    static const auto call = real<std::FILE*(const char*, const char*)>("fopen64");
    return call(path, mode);
}

}
