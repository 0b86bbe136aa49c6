# SPDX-License-Identifier: MIT
# The library for Fourier transforms. FFTW is under the GPL, so a program linked with it is, too.

set(POLHODE_FFT pocketfft CACHE STRING "library for Fourier transforms: pocketfft (BSD, included) or fftw (GPL)")
set_property(CACHE POLHODE_FFT PROPERTY STRINGS pocketfft fftw)

if(POLHODE_FFT STREQUAL "pocketfft")
  add_library(polhode_pocketfft INTERFACE)
  target_include_directories(polhode_pocketfft SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/third_party/pocketfft)
  set(fft_library $<BUILD_INTERFACE:polhode_pocketfft>)
elseif(POLHODE_FFT STREQUAL "fftw")
  include(cmake/fftw.cmake)
  if(NOT TARGET polhode::fftw)
    message(FATAL_ERROR "POLHODE_FFT is fftw, but fftw3.h, libfftw3 and libfftw3f are not all there; "
                        "install them (Debian: libfftw3-dev), or choose pocketfft")
  endif()
  set(fft_library polhode::fftw)
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
