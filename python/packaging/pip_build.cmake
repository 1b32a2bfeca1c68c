# A build by pip: headers may come as Python packages, and the license in the metadata follows the environment.
foreach(prefix IN LISTS CMAKE_PREFIX_PATH)
    if(EXISTS "${prefix}/cmeel.prefix")
        list(APPEND CMAKE_PREFIX_PATH "${prefix}/cmeel.prefix") # Eigen
    endif()
endforeach()

set(named FFTW)
if(DEFINED ENV{VISCOROLL_FFT})
    set(named "$ENV{VISCOROLL_FFT}")
endif()
if(NOT viscoroll_FFT STREQUAL named)
    message(
        FATAL_ERROR
        "The metadata of this wheel are those of one with ${named} inside, not ${viscoroll_FFT}. Set VISCOROLL_FFT="
        "${viscoroll_FFT} in the environment instead of the CMake variable viscoroll_FFT."
    )
endif()
