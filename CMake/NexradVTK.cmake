# Finds VTK and builds the VTK modules of Source/IO, Source/Filters, Source/Rendering and Source/Scene.
if(VTKNexrad_WRAP_PYTHON)
  # The wrappers are for the Python that VTK's own are for: no other could load both.
  set(nexrad_vtk_for_python Python WrappingPythonCore)
endif()
if(VTKNexrad_BUILD_VIEWER)
  find_package(Qt5 5.15 QUIET COMPONENTS Widgets)
  if(Qt5_FOUND)
    set(nexrad_vtk_for_qt ChartsCore GUISupportQt InteractionWidgets RenderingContext2D
      RenderingContextOpenGL2 ViewsContext2D)
  endif()
endif()
# What the modules, the program and the tests link.
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore FiltersExtraction FiltersSources
  ImagingCore IOCore IOGeometry IOImage IONetCDF IOXML IOOggTheora
  ParallelCore
  InteractionStyle RenderingCore RenderingFreeType RenderingOpenGL2
  RenderingVolume RenderingVolumeOpenGL2
  netcdf tiff vtksys
  OPTIONAL_COMPONENTS ParallelMPI ${nexrad_vtk_for_python} ${nexrad_vtk_for_qt})

set(nexrad_module_files
  "${CMAKE_SOURCE_DIR}/Source/IO/vtk.module"
  "${CMAKE_SOURCE_DIR}/Source/Filters/vtk.module"
  "${CMAKE_SOURCE_DIR}/Source/Rendering/vtk.module"
  "${CMAKE_SOURCE_DIR}/Source/Scene/vtk.module")
vtk_module_scan(
  MODULE_FILES ${nexrad_module_files}
  PROVIDES_MODULES nexrad_modules
  REQUIRES_MODULES nexrad_required
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${nexrad_modules}
  PACKAGE VTKNexrad
  INSTALL_EXPORT VTKNexrad
  INSTALL_HEADERS ON
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/nexrad"
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  TEST_DIRECTORY_NAME NONE)
