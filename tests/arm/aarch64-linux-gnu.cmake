# SPDX-License-Identifier: MIT
# Debian's cross compiler for 64-bit ARM, whose programs qemu runs.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
