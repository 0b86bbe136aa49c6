# SPDX-License-Identifier: MIT
# The library for Fourier transforms. FFTW is under the GPL, so a program linked with it is, too.

set(POLHODE_FFT pocketfft CACHE STRING "library for Fourier transforms: pocketfft (BSD, included) or fftw (GPL)")
set_property(CACHE POLHODE_FFT PROPERTY STRINGS pocketfft fftw)

add_library(polhode_fft INTERFACE)
if(POLHODE_FFT STREQUAL "pocketfft")
  target_include_directories(polhode_fft SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/third_party/pocketfft)
elseif(POLHODE_FFT STREQUAL "fftw")
  find_path(FFTW_HEADERS fftw3.h REQUIRED)
  find_library(FFTW_DOUBLE fftw3 REQUIRED)
  find_library(FFTW_FLOAT fftw3f REQUIRED)
  target_include_directories(polhode_fft SYSTEM INTERFACE ${FFTW_HEADERS})
  target_link_libraries(polhode_fft INTERFACE ${FFTW_DOUBLE} ${FFTW_FLOAT})
else()
  message(FATAL_ERROR "POLHODE_FFT is '${POLHODE_FFT}'; it must be pocketfft or fftw")
endif()

# Of the sources named ..._pocketfft.cpp and ..._fftw.cpp, keeps those of the chosen library.
function(polhode_choose_fft variable)
  set(sources ${${variable}})
  foreach(library IN ITEMS pocketfft fftw)
    if(NOT library STREQUAL POLHODE_FFT)
      list(FILTER sources EXCLUDE REGEX "_${library}\\.cpp$")
    endif()
  endforeach()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
