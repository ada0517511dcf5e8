# SPDX-License-Identifier: MIT
# `cmake --install`: the components compiler, shaders and tools, relocatable, with CMake and pkg-config files.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(gnomon_components compiler shaders tools)
# Where src/library_location.cpp looks, seen from the programs.
set(gnomon_shader_directory share/gnomon)
set(gnomon_package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/gnomon")

# compiler
set_target_properties(gnomon_compiler PROPERTIES EXPORT_NAME compiler)
set_target_properties(gnomon_diagnostic PROPERTIES EXPORT_NAME diagnostic)
install(TARGETS gnomon_compiler gnomon_diagnostic EXPORT gnomon_compiler ARCHIVE COMPONENT compiler)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/compiler/include/gnomon/compiler"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/gnomon" COMPONENT compiler FILES_MATCHING PATTERN "*.h")
install(FILES "${PROJECT_SOURCE_DIR}/compiler/include/gnomon/diagnostic.h"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/gnomon" COMPONENT compiler)

# shaders: the tree of the library, found from GLSL and C++ as <gnomon/...>
install(DIRECTORY "${PROJECT_SOURCE_DIR}/shaderlib/" DESTINATION "${gnomon_shader_directory}" COMPONENT shaders
        FILES_MATCHING REGEX "\\.(glsl|vert|frag|geom|comp)$" PATTERN testing EXCLUDE)
add_library(gnomon_installed_modules INTERFACE)
set_target_properties(gnomon_installed_modules PROPERTIES EXPORT_NAME modules)
target_compile_features(gnomon_installed_modules INTERFACE cxx_std_20)
target_include_directories(gnomon_installed_modules INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
                                                              "$<INSTALL_INTERFACE:share>")
target_link_libraries(gnomon_installed_modules INTERFACE glm::glm)
install(TARGETS gnomon_installed_modules EXPORT gnomon_shaders)
# Made with everything else: an installation builds nothing.
add_custom_target(gnomon_installed_header ALL)
add_dependencies(gnomon_installed_header gnomon_modules_header)
install(FILES "${PROJECT_BINARY_DIR}/shaderlib/generated/gnomon/modules.h"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/gnomon" COMPONENT shaders)
install(FILES "${CMAKE_CURRENT_LIST_DIR}/GnomonShaders.cmake" DESTINATION "${gnomon_package_directory}"
        COMPONENT shaders)

# tools
install(TARGETS gnomonc gnomon EXPORT gnomon_tools RUNTIME COMPONENT tools)

# The package: each component brings its own part and what finds the parts that are there.
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/gnomonConfig.cmake.in" "${PROJECT_BINARY_DIR}/gnomonConfig.cmake"
                              INSTALL_DESTINATION "${gnomon_package_directory}" PATH_VARS gnomon_shader_directory)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH gnomon_pc_to_prefix "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" /prefix)
configure_file("${CMAKE_CURRENT_LIST_DIR}/gnomon.pc.in" "${PROJECT_BINARY_DIR}/gnomon.pc" @ONLY)
foreach(component ${gnomon_components})
  install(EXPORT gnomon_${component} NAMESPACE gnomon:: DESTINATION "${gnomon_package_directory}"
          COMPONENT ${component})
  install(FILES "${PROJECT_BINARY_DIR}/gnomonConfig.cmake" "${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake"
          DESTINATION "${gnomon_package_directory}" COMPONENT ${component})
endforeach()
install(FILES "${PROJECT_BINARY_DIR}/gnomon.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT compiler)
