# SPDX-License-Identifier: MIT
# Loops over packs are compiled once per instruction set, with its flags. Such a file may
# instantiate inline functions of the standard library; if these were shared with the rest of the
# program, the linker might keep the copy with the wrong instructions. So each set is linked into
# one object whose only global symbols are the project's own, with the name of the set in them.

set(POLHODE_INSTRUCTION_SETS all CACHE STRING
    "instruction sets of the kernels: all, native (that of this processor), or a list; scalar is always there")

set(POLHODE_FLAGS_scalar -DHWY_COMPILE_ONLY_SCALAR)
set(known_sets scalar)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(PREPEND POLHODE_FLAGS_scalar -march=x86-64)
  list(APPEND known_sets sse4 avx2 avx512)
  set(POLHODE_FLAGS_sse4 -march=x86-64-v2)
  set(POLHODE_FLAGS_avx2 -march=x86-64-v3)
  set(POLHODE_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
endif()

# The best known instruction set of the processor that compiles.
function(polhode_native_set result)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                  OUTPUT_VARIABLE macros ERROR_QUIET)
  set(best scalar)
  if(macros MATCHES "__SSE4_2__ 1")
    set(best sse4)
  endif()
  if(macros MATCHES "__AVX2__ 1" AND macros MATCHES "__FMA__ 1")
    set(best avx2)
  endif()
  if(macros MATCHES "__AVX512F__ 1" AND macros MATCHES "__AVX512BW__ 1" AND macros MATCHES "__AVX512CD__ 1" AND
     macros MATCHES "__AVX512DQ__ 1" AND macros MATCHES "__AVX512VL__ 1")
    set(best avx512)
  endif()
  set(${result} ${best} PARENT_SCOPE)
endfunction()

set(compiled_sets ${POLHODE_INSTRUCTION_SETS})
if(compiled_sets STREQUAL "all")
  set(compiled_sets ${known_sets})
elseif(compiled_sets STREQUAL "native")
  polhode_native_set(compiled_sets)
endif()
list(PREPEND compiled_sets scalar)
list(REMOVE_DUPLICATES compiled_sets)
foreach(name IN LISTS compiled_sets)
  if(NOT name IN_LIST known_sets)
    message(FATAL_ERROR "POLHODE_INSTRUCTION_SETS has '${name}', which is not known on ${CMAKE_SYSTEM_PROCESSOR}; "
                        "choose all, native or a list of: ${known_sets}")
  endif()
endforeach()
list(LENGTH compiled_sets number_of_sets)
if(number_of_sets GREATER 1)  # the scalar one then serves only processors without any other
  list(APPEND POLHODE_FLAGS_scalar -DPOLHODE_FALLBACK -O1)
endif()

set(missing_sets)  # definitions that tell the code what is not there
foreach(name IN LISTS known_sets)
  if(NOT name IN_LIST compiled_sets)
    string(TOUPPER POLHODE_WITHOUT_${name} definition)
    list(APPEND missing_sets ${definition})
  endif()
endforeach()

# Those of GNU for any compiler: lld 14 cannot resolve the groups of an object.
find_program(POLHODE_LD NAMES ld.bfd ld REQUIRED)
find_program(POLHODE_OBJCOPY NAMES objcopy REQUIRED)

function(polhode_compile_kernels library)
  foreach(name IN LISTS compiled_sets)
    set(objects ${library}_${name})
    add_library(${objects} OBJECT ${ARGN})
    target_link_libraries(${objects} PRIVATE polhode_headers polhode_flags ${fft_library} hwy::hwy)
    target_compile_options(${objects} PRIVATE ${POLHODE_FLAGS_${name}} -ffp-contract=fast
                           -fno-tree-vectorize)  # vectorization is explicit in packs
    target_compile_definitions(${objects} PRIVATE POLHODE_LOOPS=loops_${name} HWY_DISABLE_PCLMUL_AES ${missing_sets})
    if(POLHODE_SANITIZE)  # runs only on the build machine, so sharing is harmless
      target_sources(${library} PRIVATE $<TARGET_OBJECTS:${objects}>)
    else()
      set(merged ${CMAKE_CURRENT_BINARY_DIR}/${objects}.o)
      add_custom_command(
        OUTPUT ${merged}
        COMMAND ${POLHODE_LD} -r --force-group-allocation -o ${merged}
                $<TARGET_OBJECTS:${objects}>
        COMMAND ${POLHODE_OBJCOPY} --wildcard "--keep-global-symbol=*polhode*loops_${name}*" ${merged}
        DEPENDS ${objects} $<TARGET_OBJECTS:${objects}>
        COMMAND_EXPAND_LISTS VERBATIM
        COMMENT "Joining the ${name} loops")
      set_source_files_properties(${merged} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
      target_sources(${library} PRIVATE ${merged})
    endif()
  endforeach()
endfunction()
