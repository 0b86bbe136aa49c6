# SPDX-License-Identifier: MIT
# Data files built into the program: molecule models, the default run and its initial configuration.

# polhode_embed(VARIABLE FILE...): VARIABLE names a generated source that defines embedded_files().
function(polhode_embed variable)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_files.cpp)
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DROOT=${PROJECT_SOURCE_DIR}/data "-DFILES=${files}"
            -P ${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake
    VERBATIM
    COMMENT "Embedding data files")
  set(${variable} ${source} PARENT_SCOPE)
endfunction()
