# Write viscoroll.pc, for builds without CMake. For a static library it lists the dependencies that users must link.
get_target_property(library_type viscoroll TYPE)
set(pc_requires "")
set(pc_libs "")
if(library_type STREQUAL "STATIC_LIBRARY")
    set(pc_libs "${CMAKE_THREAD_LIBS_INIT}")
    if(viscoroll_FFT STREQUAL "FFTW")
        set(pc_requires fftw3)
    endif()
endif()
# The prefix is relative to the folder of viscoroll.pc, so that the installed files can be moved.
file(RELATIVE_PATH pc_prefix "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
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
