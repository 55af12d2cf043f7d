# What find_package(VTKNexrad) reads after cmake --install.
include(CMakePackageConfigHelpers)
set(nexrad_package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/VTKNexrad")

# nexrad_vtk_components(<module> <variable>): the libraries of VTK that a module and those below it link, which a
# program must find that links the module.
function(nexrad_vtk_components module variable)
  get_target_property(libraries ${module} LINK_LIBRARIES)
  set(components "")
  foreach(library IN LISTS libraries)
    if(library IN_LIST nexrad_modules)
      nexrad_vtk_components(${library} below)
      list(APPEND components ${below})
    elseif(library MATCHES "^VTK::")
      get_target_property(type ${library} TYPE)
      if(NOT type STREQUAL "INTERFACE_LIBRARY") # VTK's own libraries bring what has only headers
        string(REGEX REPLACE "^VTK::" "" component "${library}")
        list(APPEND components ${component})
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES components)
  set(${variable} ${components} PARENT_SCOPE)
endfunction()

set(nexrad_package_components Core)
set(nexrad_package_vtk "")
if(VTKNexrad_BUILD_VTK)
  foreach(module IN LISTS nexrad_modules)
    string(REGEX REPLACE "^VTKNexrad::" "" component "${module}")
    list(APPEND nexrad_package_components ${component})
    nexrad_vtk_components(${module} libraries)
    list(JOIN libraries " " libraries)
    string(APPEND nexrad_package_vtk "set(_nexrad_vtk_${component} ${libraries})\n")
  endforeach()
endif()
list(JOIN nexrad_package_components " " nexrad_package_components)

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
