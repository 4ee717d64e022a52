# Linux on AArch64 with Debian's cross compiler; what it makes runs here under qemu-user. LEADSCREW_AARCH64_ROOT: a folder with
# Debian's libraries for that processor, which script/aarch64 makes.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES LEADSCREW_AARCH64_ROOT)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # GCC tells of an interface that changed with its version 10
set(CMAKE_SYSROOT ${LEADSCREW_AARCH64_ROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${LEADSCREW_AARCH64_ROOT}/usr/lib/aarch64-linux-gnu/pkgconfig)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${LEADSCREW_AARCH64_ROOT})
