# What find_package(VTKNexrad) reads after cmake --install.
include(CMakePackageConfigHelpers)
set(nexrad_package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/VTKNexrad")

set(nexrad_package_components Core)
if(VTKNexrad_BUILD_VTK)
  list(APPEND nexrad_package_components IO Filters Rendering Scene)
  set(nexrad_package_vtk ${nexrad_required})
  list(TRANSFORM nexrad_package_vtk REPLACE "^VTK::" "")
  list(JOIN nexrad_package_vtk " " nexrad_package_vtk)
endif()

install(EXPORT VTKNexradCore
  NAMESPACE VTKNexrad::
  FILE VTKNexrad-core-targets.cmake
  DESTINATION "${nexrad_package_folder}"
  COMPONENT development)
# The modules' own file for the build tree, which VTK writes, needs this one.
export(EXPORT VTKNexradCore
  NAMESPACE VTKNexrad::
  FILE "${CMAKE_BINARY_DIR}/${nexrad_package_folder}/VTKNexrad-core-targets.cmake")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/VTKNexradConfig.cmake.in" "${CMAKE_BINARY_DIR}/package/VTKNexradConfig.cmake"
  INSTALL_DESTINATION "${nexrad_package_folder}"
  NO_SET_AND_CHECK_MACRO
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Until 1.0 a new minor version may change any interface.
write_basic_package_version_file("${CMAKE_BINARY_DIR}/package/VTKNexradConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/package/VTKNexradConfig.cmake"
  "${CMAKE_BINARY_DIR}/package/VTKNexradConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/NexradGeographicLib.cmake"
  DESTINATION "${nexrad_package_folder}"
  COMPONENT development)
