# SPDX-License-Identifier: MIT
# Loops over packs are compiled once per instruction set, with its flags. Such a file may
# instantiate inline functions of the standard library; if these were shared with the rest of the
# program, the linker might keep the copy with the wrong instructions. So each set is linked into
# one object whose only global symbols are the project's own, with the name of the set in them.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(POLHODE_TARGET_NAMES scalar sse4 avx2 avx512)
  set(POLHODE_FLAGS_scalar -march=x86-64 -DHWY_COMPILE_ONLY_SCALAR)
  set(POLHODE_FLAGS_sse4 -march=x86-64-v2)
  set(POLHODE_FLAGS_avx2 -march=x86-64-v3)
  set(POLHODE_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
else()
  set(POLHODE_TARGET_NAMES scalar)
  set(POLHODE_FLAGS_scalar -DHWY_COMPILE_ONLY_SCALAR)
endif()

function(polhode_compile_per_target library)
  foreach(name IN LISTS POLHODE_TARGET_NAMES)
    set(objects ${library}_${name})
    add_library(${objects} OBJECT ${ARGN})
    target_link_libraries(${objects} PRIVATE polhode_headers polhode_flags hwy::hwy)
    target_compile_options(${objects} PRIVATE ${POLHODE_FLAGS_${name}} -ffp-contract=fast
                           -fno-tree-vectorize)  # vectorization is explicit in packs
    target_compile_definitions(${objects} PRIVATE POLHODE_LOOPS=loops_${name} HWY_DISABLE_PCLMUL_AES)
    if(POLHODE_SANITIZE)  # runs only on the build machine, so sharing is harmless
      target_sources(${library} PRIVATE $<TARGET_OBJECTS:${objects}>)
    else()
      set(merged ${CMAKE_CURRENT_BINARY_DIR}/${objects}.o)
      add_custom_command(
        OUTPUT ${merged}
        COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${merged}
                $<TARGET_OBJECTS:${objects}>
        COMMAND ${CMAKE_OBJCOPY} --wildcard "--keep-global-symbol=*polhode*loops_${name}*" ${merged}
        DEPENDS ${objects} $<TARGET_OBJECTS:${objects}>
        COMMAND_EXPAND_LISTS VERBATIM
        COMMENT "Joining the ${name} loops")
      set_source_files_properties(${merged} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
      target_sources(${library} PRIVATE ${merged})
    endif()
  endforeach()
endfunction()
