# Toolchain file for Linux computers with 64-bit ARM processors, as the Raspberry Pi. KFAST_SYSROOT is the folder that
# scripts/make_sysroot.py makes for arm64. clang takes less time than g++, by a third; linker and C++ library are those of
# Debian's g++-aarch64-linux-gnu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET aarch64-linux-gnu)
set(CMAKE_CXX_COMPILER_TARGET aarch64-linux-gnu)
set(CMAKE_STRIP aarch64-linux-gnu-strip)
set(KFAST_DEBIAN_ARCHITECTURE arm64)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES KFAST_SYSROOT)

if(NOT EXISTS "${KFAST_SYSROOT}/made_of")
    message(FATAL_ERROR "There are no libraries for arm64 in '${KFAST_SYSROOT}'.\n"
        "scripts/build linux-arm64 downloads them, or: python3 scripts/make_sysroot.py arm64 build/linux-arm64/root")
endif()
set(CMAKE_SYSROOT ${KFAST_SYSROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${KFAST_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR}
    ${KFAST_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${KFAST_SYSROOT}/usr/share/pkgconfig)
