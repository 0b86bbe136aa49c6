# SPDX-License-Identifier: MIT
# cmake --install: headers, library, program, and the files by which other projects find them. Data files
# are in the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/polhode)
set(package_files ${CMAKE_CURRENT_BINARY_DIR}/polhode-config-version.cmake)
set(pkg_config_files polhode-headers.pc)

# polhode_install_target(TARGET NAME): other projects call it polhode::NAME.
function(polhode_install_target target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT polhode-${name})
  install(EXPORT polhode-${name} NAMESPACE polhode:: DESTINATION ${package_folder})
endfunction()

install(DIRECTORY include/polhode DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
polhode_install_target(polhode_headers headers)
if(POLHODE_LIBRARY)
  polhode_install_target(polhode_core core)
  polhode_install_target(polhode library)
  if(POLHODE_HDF5)
    list(APPEND package_files cmake/hdf5.cmake)
  endif()
  list(APPEND pkg_config_files polhode-core.pc polhode.pc)
  install(FILES third_party/pocketfft/LICENSE.md DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE-pocketfft.md)
endif()
if(TARGET polhode_cli)
  install(TARGETS polhode_cli)
endif()

configure_package_config_file(cmake/polhode-config.cmake.in polhode-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(polhode-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/polhode-config.cmake ${package_files} DESTINATION ${package_folder})

# For pkg-config. Paths are relative to the file, so the installed tree may be moved. The library is static, so who links with it needs all that it is built on.
file(RELATIVE_PATH pkg_config_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
if(POLHODE_LIBRARY)
  list(TRANSFORM missing_sets PREPEND " -D" OUTPUT_VARIABLE pkg_config_flags)
  string(JOIN "" pkg_config_flags ${pkg_config_flags})
  set(pkg_config_libraries ${POLHODE_HDF5_LIBRARY})
  list(JOIN pkg_config_libraries " " pkg_config_libraries)
endif()
foreach(file IN LISTS pkg_config_files)
  configure_file(cmake/${file}.in ${file} @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
