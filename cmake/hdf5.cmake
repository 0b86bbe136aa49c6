# SPDX-License-Identifier: MIT
# polhode::hdf5, as a target. Included by the project and by its installed package.
find_path(POLHODE_HDF5_HEADERS hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(POLHODE_HDF5_LIBRARY NAMES hdf5_serial hdf5)
mark_as_advanced(POLHODE_HDF5_HEADERS POLHODE_HDF5_LIBRARY)
if(POLHODE_HDF5_HEADERS AND POLHODE_HDF5_LIBRARY AND NOT TARGET polhode::hdf5)
  add_library(polhode::hdf5 INTERFACE IMPORTED GLOBAL)
  target_include_directories(polhode::hdf5 SYSTEM INTERFACE ${POLHODE_HDF5_HEADERS})
  target_link_libraries(polhode::hdf5 INTERFACE ${POLHODE_HDF5_LIBRARY})
endif()
