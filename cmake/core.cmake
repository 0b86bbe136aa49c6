# SPDX-License-Identifier: MIT
# The core of the library: polhode::core has molecules, forces and integration, without files. Other engines, such as
# LAMMPS, take it alone.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
include(cmake/kernels.cmake)

foreach(folder IN ITEMS base math model forces integrate)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS src/${folder}/*.cpp)
  list(APPEND core_sources ${files})
endforeach()
list(FILTER core_sources EXCLUDE REGEX "/math/(fit|prediction)\\.cpp$")  # by Boost, for statistics
list(APPEND core_sources ${PROJECT_SOURCE_DIR}/src/ensemble/langevin.cpp ${PROJECT_SOURCE_DIR}/src/ensemble/velocity_rescaling.cpp
     ${PROJECT_SOURCE_DIR}/src/ensemble/kernels/langevin.cpp)
set(core_kernels ${core_sources})
list(FILTER core_sources EXCLUDE REGEX "/kernels/")
list(FILTER core_kernels INCLUDE REGEX "/kernels/")

# Alone, it is for programs that may have another {fmt}.
set(core_fmt fmt::fmt)
if(NOT POLHODE_LIBRARY)
  set(core_fmt fmt::fmt-header-only)
endif()

# polhode_static_library(TARGET SOURCE...): the sources are a target of their own, or none would be compiled until all
# kernels are.
function(polhode_static_library target)
  add_library(${target}_sources OBJECT ${ARGN})
  add_library(${target} STATIC $<TARGET_OBJECTS:${target}_sources>)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  polhode_make_shareable(${target}_sources)
endfunction()

polhode_static_library(polhode_core ${core_sources})
set_target_properties(polhode_core PROPERTIES OUTPUT_NAME polhode-core)
add_library(polhode::core ALIAS polhode_core)
foreach(target IN ITEMS polhode_core_sources polhode_core)
  target_compile_definitions(${target} PUBLIC ${missing_sets})
  # What is only headers has served when the library is built.
  target_link_libraries(${target} PUBLIC polhode_headers
                        PRIVATE Threads::Threads ${core_fmt} hwy::hwy $<BUILD_INTERFACE:polhode_pocketfft>
                                $<BUILD_INTERFACE:polhode_flags> $<BUILD_INTERFACE:Eigen3::Eigen>)
endforeach()
set_source_files_properties(src/base/version.cpp PROPERTIES
                            COMPILE_DEFINITIONS POLHODE_VERSION="${PROJECT_VERSION}" SKIP_PRECOMPILE_HEADERS ON)
polhode_compile_kernels(polhode_core ${core_kernels})
