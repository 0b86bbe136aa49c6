# SPDX-License-Identifier: MIT
# The library: polhode::library.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # a project that this one is a part of links with them, too
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
if(POLHODE_HDF5)
  include(cmake/hdf5.cmake)
  if(NOT TARGET polhode::hdf5)
    message(FATAL_ERROR "hdf5.h and its library are not there; install them (Debian: libhdf5-dev), "
                        "or set POLHODE_HDF5=OFF, which leaves out the format H5MD")
  endif()
endif()
include(cmake/kernels.cmake)
include(cmake/embed.cmake)

file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
set(kernel_sources ${sources})
list(FILTER sources EXCLUDE REGEX "/kernels/")
list(FILTER kernel_sources INCLUDE REGEX "/kernels/")
if(POLHODE_HDF5)
  list(FILTER sources EXCLUDE REGEX "formats/h5md_missing\\.cpp$")
else()
  list(FILTER sources EXCLUDE REGEX "formats/(h5md_(reader|series|writer)|variable_text)\\.cpp$")
endif()
file(GLOB embedded CONFIGURE_DEPENDS data/molecules/*.toml data/molecules/*.txt data/start/*.gro data/runs/*.toml
     data/plots/*.gp data/plots/*.toml)
polhode_embed(embedded_source ${embedded})
# Compilers have no limit of 64 KiB, of which clang++ warns as the standard's.
set_source_files_properties(${embedded_source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)

# The sources are a target of their own, or none would be compiled until all kernels are.
add_library(polhode_sources OBJECT ${sources} ${embedded_source})
add_library(polhode STATIC $<TARGET_OBJECTS:polhode_sources>)
add_library(polhode::library ALIAS polhode)
set_target_properties(polhode PROPERTIES LINKER_LANGUAGE CXX)
foreach(target IN ITEMS polhode_sources polhode)
  target_compile_definitions(${target} PUBLIC ${missing_sets})
  # What is only headers has served when the library is built.
  target_link_libraries(${target} PUBLIC polhode_headers
                        PRIVATE Threads::Threads fmt::fmt hwy::hwy tomlplusplus::tomlplusplus
                                $<TARGET_NAME_IF_EXISTS:polhode::hdf5> $<BUILD_INTERFACE:polhode_pocketfft>
                                $<BUILD_INTERFACE:polhode_flags> $<BUILD_INTERFACE:Eigen3::Eigen>
                                $<BUILD_INTERFACE:Boost::headers>
                                $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
endforeach()
polhode_make_shareable(polhode_sources)
set_source_files_properties(src/base/version.cpp PROPERTIES
                            COMPILE_DEFINITIONS POLHODE_VERSION="${PROJECT_VERSION}" SKIP_PRECOMPILE_HEADERS ON)

# Compile time: files that read input and write reports are optimized less, and developers alone
# find out whether each file includes what it uses.
set(cold_sources ${sources})
list(FILTER cold_sources INCLUDE REGEX "/src/(io/[^/]*|io/gromacs/[^/]*|io/lammps/[^/]*|run/(adviser|analysis|study)/[^/]*|math/(fit|prediction)\\.cpp)$")
set_source_files_properties(${cold_sources} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
function(polhode_precompile target)
  if(NOT POLHODE_DEVELOPER)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <fmt/core.h> <fstream> <functional>
                              <map> <memory> <optional> <set> <sstream> <string> <variant> <vector>)
  endif()
endfunction()
polhode_precompile(polhode_sources)
polhode_compile_kernels(polhode ${kernel_sources})
