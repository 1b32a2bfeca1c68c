# Find the header of PocketFFT and define the target PocketFFT::pocketfft. Packages of vcpkg, Fedora and Arch contain it
# as pocketfft_hdronly.h; the Python package pythran contains it as pocketfft.hpp.
find_path(
    PocketFFT_INCLUDE_DIR
    NAMES pocketfft_hdronly.h pocketfft.hpp
    HINTS ${CMAKE_PREFIX_PATH}
    PATH_SUFFIXES pocketfft pythran/pythonic/numpy/fft
)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PocketFFT REQUIRED_VARS PocketFFT_INCLUDE_DIR)

if(PocketFFT_FOUND AND NOT TARGET PocketFFT::pocketfft)
    add_library(PocketFFT::pocketfft INTERFACE IMPORTED)
    set_target_properties(
        PocketFFT::pocketfft
        PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${PocketFFT_INCLUDE_DIR}"
    )
endif()
mark_as_advanced(PocketFFT_INCLUDE_DIR)
