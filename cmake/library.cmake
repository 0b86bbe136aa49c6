# SPDX-License-Identifier: MIT
# The library: polhode::library, the core and all that has to do with files and runs.
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
include(cmake/embed.cmake)
include(cmake/quick.cmake)

file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
list(REMOVE_ITEM sources ${core_sources} ${core_kernels})
set(kernel_sources ${sources})
list(FILTER sources EXCLUDE REGEX "/kernels/")
list(FILTER kernel_sources INCLUDE REGEX "/kernels/")
if(POLHODE_HDF5)
  list(FILTER sources EXCLUDE REGEX "formats/h5md_missing\\.cpp$")
else()
  list(FILTER sources EXCLUDE REGEX "formats/h5md_(reader|series|writer)\\.cpp$")
endif()
file(GLOB embedded CONFIGURE_DEPENDS data/molecules/*.toml data/molecules/*.txt data/start/*.gro data/runs/*.toml
     data/plots/*.gp data/plots/*.toml data/pages/*.html)
polhode_embed(embedded_source ${embedded})
# Compilers have no limit of 64 KiB, of which clang++ warns as the standard's.
set_source_files_properties(${embedded_source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)

# Compile time: files that read input, prepare and report runs are optimized less. In one of them, io/lammps/write_tables.cpp,
# g++ 12 at -O2 takes values of pairs of sites that a shape does not have for uninitialized.
set(cold_sources ${sources})
list(FILTER cold_sources INCLUDE REGEX "/src/(io/(settings|figures|files|coordinates|topology|gromacs|lammps)/[^/]*|run/[^/]*|run/(adviser|analysis|canonical|conversion|listing|prepare|study|top)/[^/]*|run/simulation/(simulation|files/[^/]*|report/(averages|ensemble_[a-z]*|run_report|summary|warnings)|system/system[a-z_]*)\\.cpp|math/(fit|prediction)\\.cpp)$")
list(REMOVE_ITEM sources ${cold_sources})
add_library(polhode_cold_sources OBJECT ${cold_sources} ${embedded_source})
target_compile_options(polhode_cold_sources PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
polhode_make_shareable(polhode_cold_sources)

polhode_static_library(polhode ${sources})
target_sources(polhode PRIVATE $<TARGET_OBJECTS:polhode_cold_sources>)
add_library(polhode::library ALIAS polhode)
target_link_libraries(polhode PUBLIC polhode_core)
foreach(target IN ITEMS polhode_sources polhode_cold_sources polhode)
  target_compile_definitions(${target} PUBLIC ${missing_sets})
  target_link_libraries(${target} PUBLIC polhode_headers
                                  PRIVATE Threads::Threads fmt::fmt hwy::hwy tomlplusplus::tomlplusplus
                                          $<TARGET_NAME_IF_EXISTS:polhode::hdf5> $<BUILD_INTERFACE:polhode_flags>
                                          $<BUILD_INTERFACE:Eigen3::Eigen> $<BUILD_INTERFACE:Boost::headers>
                                          $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
endforeach()

foreach(target IN ITEMS polhode_core_sources polhode_sources polhode_cold_sources)
  polhode_precompile(${target})
endforeach()
polhode_compile_in_groups(polhode_core_sources ${core_sources})
polhode_compile_in_groups(polhode_sources ${sources})
polhode_compile_in_groups(polhode_cold_sources ${cold_sources})
polhode_compile_kernels(polhode ${kernel_sources})
