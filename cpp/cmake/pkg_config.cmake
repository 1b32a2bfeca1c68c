# viscoroll.pc, for builds without CMake. What a static library needs, its users link.
get_target_property(library_type viscoroll TYPE)
if(library_type STREQUAL "STATIC_LIBRARY")
    set(pc_private "")
else()
    set(pc_private ".private")
endif()
set(pc_requires "")
if(viscoroll_FFT STREQUAL "FFTW")
    set(pc_requires fftw3)
endif()
foreach(directory IN ITEMS includedir libdir)
    string(TOUPPER ${directory} variable)
    set(pc_${directory} "${CMAKE_INSTALL_${variable}}")
    if(NOT IS_ABSOLUTE "${pc_${directory}}")
        set(pc_${directory} "\${prefix}/${pc_${directory}}")
    endif()
endforeach()
configure_file(cmake/viscoroll.pc.in viscoroll.pc @ONLY)
install(
    FILES "${CMAKE_CURRENT_BINARY_DIR}/viscoroll.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
    COMPONENT library
)
