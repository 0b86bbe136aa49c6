# SPDX-License-Identifier: MIT
# Loops over packs are compiled once per instruction set, with its flags. Such a file may
# instantiate inline functions of the standard library; if these were shared with the rest of the
# program, the linker might keep the copy with the wrong instructions. So each set is linked into
# one object whose only global symbols are the project's own, with the name of the set in them.

set(POLHODE_INSTRUCTION_SETS all CACHE STRING
    "instruction sets of the kernels: all, native (that of this processor), or a list; scalar is always there")

# Flags of each set, and what the compiler defines where the processor has it. The order is that of InstructionSet.
set(all_sets scalar sse4 avx2 avx512 neon)
set(POLHODE_FLAGS_scalar -DHWY_COMPILE_ONLY_SCALAR)
set(POLHODE_FLAGS_sse4 -march=x86-64-v2)
set(POLHODE_MACROS_sse4 __SSE4_2__)
set(POLHODE_FLAGS_avx2 -march=x86-64-v3)
set(POLHODE_MACROS_avx2 __AVX2__ __FMA__)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # other order of instructions, 2 to 18 % faster on Zen 4
  list(APPEND POLHODE_FLAGS_avx2 -mtune=znver2)
endif()
set(POLHODE_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
set(POLHODE_MACROS_avx512 __AVX512F__ __AVX512BW__ __AVX512CD__ __AVX512DQ__ __AVX512VL__)
set(POLHODE_FLAGS_neon -march=armv8-a+crypto)  # Highway compiles NEON only with these instructions, which are not used
set(POLHODE_MACROS_neon __ARM_NEON)

# The sets of the processor to compile for, slowest first. Where the best of them is on all such processors, any copy of
# an inline function will do, and the sets need not be kept apart.
set(known_sets scalar)
set(keep_sets_apart FALSE)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(PREPEND POLHODE_FLAGS_scalar -march=x86-64)
  list(APPEND known_sets sse4 avx2 avx512)
  set(keep_sets_apart TRUE)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64|ARM64")
  list(APPEND known_sets neon)
endif()

# The best known instruction set of the processor that compiles.
function(polhode_native_set result)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                  OUTPUT_VARIABLE macros ERROR_QUIET)
  foreach(name IN LISTS known_sets)
    set(there TRUE)
    foreach(macro IN LISTS POLHODE_MACROS_${name})
      if(NOT macros MATCHES "${macro} 1")
        set(there FALSE)
      endif()
    endforeach()
    if(there)
      set(best ${name})
    endif()
  endforeach()
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
# If better sets are compiled, too, only processors without them use the scalar set: it has one pair loop for all molecules. For
# developers, so has every set but the best one of their processor. This loop and -O1 compile in 4 s instead of 25 s (AVX2).
if(number_of_sets GREATER 1)
  list(APPEND POLHODE_FLAGS_scalar -DPOLHODE_FALLBACK $<$<NOT:$<CONFIG:Debug>>:-O1>)
endif()
if(POLHODE_DEVELOPER)
  polhode_native_set(native_set)
  foreach(name IN ITEMS sse4 avx2 avx512)
    if(native_set IN_LIST compiled_sets AND NOT name STREQUAL native_set)
      list(APPEND POLHODE_FLAGS_${name} -DPOLHODE_FALLBACK $<$<NOT:$<CONFIG:Debug>>:-O1>)
    endif()
  endforeach()
endif()

set(missing_sets)  # definitions that tell the code what is not there
foreach(name IN LISTS all_sets)
  if(NOT name IN_LIST compiled_sets)
    string(TOUPPER POLHODE_WITHOUT_${name} definition)
    list(APPEND missing_sets ${definition})
  endif()
endforeach()

if(POLHODE_SANITIZE)  # runs only on the build machine
  set(keep_sets_apart FALSE)
endif()
if(keep_sets_apart)  # by GNU's programs for any compiler: lld 14 cannot resolve the groups of an object
  find_program(POLHODE_LD NAMES ld.bfd ld REQUIRED)
  find_program(POLHODE_OBJCOPY NAMES objcopy REQUIRED)
endif()

# polhode_make_shareable(TARGET): its objects can also be linked into a shared library, such as the module for Python.
# Nothing in them can be replaced from outside, so calls cost what they cost in a program.
function(polhode_make_shareable target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fvisibility=hidden $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endfunction()

add_library(polhode_pocketfft INTERFACE)
target_include_directories(polhode_pocketfft SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/third_party/pocketfft)

function(polhode_compile_kernels library)
  # The loops over pairs unroll into several hundred operations, more than a processor looks ahead; by itself g++ orders
  # them only after it has assigned registers. The other options, which concern registers, were chosen by measurements on
  # a Zen 4 (bench/results/2026-11-28-compiler-options.md).
  set(of_set "STREQUAL:$<TARGET_PROPERTY:POLHODE_SET>,")
  foreach(source IN LISTS ARGN)
    if(source MATCHES "/pair_loops_" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      set_property(SOURCE ${source} PROPERTY COMPILE_OPTIONS -fschedule-insns -fsched-pressure
                   "$<$<${of_set}avx512>:-fweb;-frename-registers;-fno-ivopts>"
                   "$<$<${of_set}avx2>:-fira-loop-pressure;-frename-registers;-fno-sched-dep-count-heuristic>")
    endif()
    if(source MATCHES "/pair_(loops|derivative)_")  # nothing in them throws; they compile in 8 % less time
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -fno-exceptions)
    endif()
  endforeach()
  foreach(name IN LISTS compiled_sets)
    set(objects ${library}_${name})
    add_library(${objects} OBJECT ${ARGN})
    set_target_properties(${objects} PROPERTIES POLHODE_SET ${name})
    target_link_libraries(${objects} PRIVATE polhode_headers polhode_flags polhode_pocketfft hwy::hwy)
    target_compile_options(${objects} PRIVATE ${POLHODE_FLAGS_${name}} -ffp-contract=fast
                           -fno-tree-vectorize)  # vectorization is explicit in packs
    polhode_make_shareable(${objects})
    target_compile_definitions(${objects} PRIVATE POLHODE_LOOPS=loops_${name} HWY_DISABLE_PCLMUL_AES ${missing_sets})
    if(NOT keep_sets_apart)
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
