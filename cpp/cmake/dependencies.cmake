# Find the libraries that the build needs. If one is missing, the message names packages that contain it.

find_package(Eigen3 QUIET NO_MODULE)
if(NOT Eigen3_FOUND OR Eigen3_VERSION VERSION_LESS 3.4)
    message(
        FATAL_ERROR
        "viscoroll needs the headers of Eigen, 3.4 or later. Install one of\n"
        "  apt install libeigen3-dev        (Debian, Ubuntu)\n"
        "  dnf install eigen3-devel         (Fedora)\n"
        "  brew install eigen               (macOS)\n"
        "  vcpkg install eigen3             (Windows)\n"
        "  conda install -c conda-forge eigen\n"
        "or name the prefix that has it: -DCMAKE_PREFIX_PATH=DIR"
    )
endif()

if(viscoroll_FFT STREQUAL "FFTW")
    find_package(FFTW3 QUIET)
    if(NOT FFTW3_FOUND)
        message(
            FATAL_ERROR
            "viscoroll needs FFTW 3. Install one of\n"
            "  apt install libfftw3-dev         (Debian, Ubuntu)\n"
            "  dnf install fftw-devel           (Fedora)\n"
            "  brew install fftw                (macOS)\n"
            "  vcpkg install fftw3              (Windows)\n"
            "  conda install -c conda-forge fftw\n"
            "or name the prefix that has it: -DCMAKE_PREFIX_PATH=DIR\n"
            "or do without, under a permissive license: -Dviscoroll_FFT=PocketFFT; with pip, set VISCOROLL_FFT=PocketFFT"
            " in the environment, and nothing but a compiler is needed"
        )
    endif()
elseif(viscoroll_FFT STREQUAL "PocketFFT")
    find_package(PocketFFT QUIET)
    if(NOT PocketFFT_FOUND)
        message(
            FATAL_ERROR
            "viscoroll is configured with PocketFFT and does not find its header, pocketfft_hdronly.h. Install one of\n"
            "  dnf install pocketfft-devel      (Fedora)\n"
            "  vcpkg install pocketfft          (Windows, and others)\n"
            "  python3 -m pip install --no-deps --target DIR pythran     (anywhere: a Python package that carries it)\n"
            "and name the prefix that has it: -DCMAKE_PREFIX_PATH=DIR"
        )
    endif()
else()
    message(FATAL_ERROR "viscoroll_FFT must be FFTW or PocketFFT, got ${viscoroll_FFT}")
endif()

find_package(Threads REQUIRED)
