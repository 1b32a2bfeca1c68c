# Compiles for 64-bit Windows by the MinGW-w64 of Debian, and runs what is compiled by Wine.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
# The compiler's own libraries would have to stand beside each program.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
