# Debian packages, by cpack -G DEB in a build with the prefix /usr (Utilities/make-packages).
set(CPACK_PACKAGE_NAME vtk-nexrad)
set(CPACK_PACKAGE_CONTACT "The vtk-nexrad developers <vtk-nexrad@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL runtime development)
if(TARGET VTKNexrad::Python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
# What the files link says which packages they need; the libraries of this project are found here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME vtk-nexrad)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "The program nexrad3d and the libraries: they read NEXRAD Level II files of any number of sites, merge them into volumes in time, and draw them.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libgl1-mesa-dri")

set(same_version "vtk-nexrad (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME vtk-nexrad-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same_version}, libvtk9-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Headers of the libraries, and the package that CMake's find_package(VTKNexrad) finds.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-vtknexrad)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "${same_version}, python3-vtk9, python3-numpy, python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-xarray")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "The Python package vtknexrad: radar files and merged volumes as numpy arrays and xarray datasets, and the classes of vtk-nexrad beside VTK's own.")

foreach(package IN ITEMS runtime:vtk-nexrad development:vtk-nexrad-dev python:python3-vtknexrad)
  string(REPLACE ":" ";" package "${package}")
  list(GET package 0 component)
  list(GET package 1 name)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}" RENAME copyright COMPONENT ${component})
endforeach()

install(FILES "${PROJECT_SOURCE_DIR}/Data/README.md"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/vtk-nexrad" RENAME data-and-licences.md COMPONENT runtime)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Documentation/User/Examples"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/python3-vtknexrad" COMPONENT python
  FILES_MATCHING PATTERN "*.py" PATTERN "*.ipynb")

include(CPack)
