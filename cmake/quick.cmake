# SPDX-License-Identifier: MIT
# Most of the time of a build goes into headers. A quick build compiles the sources of a folder in groups, and headers of
# the standard library once. Developers do without: a change compiles one file, and each file includes what it uses.
# Sources of a group share their anonymous namespaces, so a name that two of them define is an error of the compiler.
set(largest_group 10)

# polhode_compile_in_groups(TARGET SOURCE...): these sources of the target, which have absolute paths
function(polhode_compile_in_groups target)
  if(NOT POLHODE_QUICK_BUILD)
    return()
  endif()
  foreach(source IN LISTS ARGN)
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND of_${folder} ${source})
    list(LENGTH of_${folder} number)
    math(EXPR group "(${number} - 1) / ${largest_group}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ takes what is in the sources of a group for parts of headers.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# polhode_precompile(TARGET)
function(polhode_precompile target)
  if(POLHODE_QUICK_BUILD)
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <fmt/core.h> <fstream> <functional>
                              <map> <memory> <optional> <set> <sstream> <string> <variant> <vector>)
    # g++ no longer knows that these headers are the system's, about which it does not warn.
    target_compile_options(${target} PRIVATE
                           $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>)
  endif()
endfunction()
