# GeographicLib ships a find module on Debian and a package configuration elsewhere.
find_package(GeographicLib CONFIG QUIET)
if(NOT GeographicLib_FOUND)
  find_path(GeographicLib_INCLUDE_DIR GeographicLib/Geodesic.hpp REQUIRED)
  find_library(GeographicLib_LIBRARY NAMES GeographicLib Geographic REQUIRED)
  mark_as_advanced(GeographicLib_INCLUDE_DIR GeographicLib_LIBRARY)
  add_library(GeographicLib::GeographicLib UNKNOWN IMPORTED)
  set_target_properties(GeographicLib::GeographicLib PROPERTIES
    IMPORTED_LOCATION "${GeographicLib_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${GeographicLib_INCLUDE_DIR}")
endif()
