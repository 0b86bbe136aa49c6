# SPDX-License-Identifier: MIT
# polhode::fftw, in double and in single precision. Included by the project and by its installed package.
find_path(POLHODE_FFTW_HEADERS fftw3.h)
find_library(POLHODE_FFTW_DOUBLE fftw3)
find_library(POLHODE_FFTW_FLOAT fftw3f)
mark_as_advanced(POLHODE_FFTW_HEADERS POLHODE_FFTW_DOUBLE POLHODE_FFTW_FLOAT)
if(POLHODE_FFTW_HEADERS AND POLHODE_FFTW_DOUBLE AND POLHODE_FFTW_FLOAT AND NOT TARGET polhode::fftw)
  add_library(polhode::fftw INTERFACE IMPORTED GLOBAL)
  target_include_directories(polhode::fftw SYSTEM INTERFACE ${POLHODE_FFTW_HEADERS})
  target_link_libraries(polhode::fftw INTERFACE ${POLHODE_FFTW_DOUBLE} ${POLHODE_FFTW_FLOAT})
endif()
