# Finds ParaView, and builds the modules of Source/ and the plugin of Plugins/ParaView against it. ParaView
# brings a VTK of its own, so a build is either for ParaView or for another VTK.
find_package(ParaView 5.11 REQUIRED COMPONENTS
  RemotingCore RemotingServerManager RemotingViews
  OPTIONAL_COMPONENTS Python)
find_package(VTK REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  IOCore ParallelCore RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 netcdf vtksys
  OPTIONAL_COMPONENTS glew opengl Python WrappingPythonCore
  PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)

# The folder that a user copies, or that ParaView looks into when it has the same prefix.
set(nexrad_plugins "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
set(nexrad_plugin_folder "${CMAKE_INSTALL_LIBDIR}/${nexrad_plugins}/VTKNexrad")
set_target_properties(VTKNexradCore PROPERTIES
  LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${nexrad_plugin_folder}"
  INSTALL_RPATH "$ORIGIN")
install(TARGETS VTKNexradCore
  LIBRARY DESTINATION "${nexrad_plugin_folder}" COMPONENT paraview_plugins NAMELINK_SKIP)

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugins/ParaView/paraview.plugin"
  PROVIDES_PLUGINS nexrad_paraview_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${nexrad_paraview_plugins}
  PLUGINS_COMPONENT paraview_plugins
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${nexrad_plugins}"
  PLUGINS_FILE_NAME vtknexrad.paraview.xml
  INSTALL_HEADERS OFF
  DISABLE_XML_DOCUMENTATION ON) # it needs tools of Qt that ParaView's packages do not bring
