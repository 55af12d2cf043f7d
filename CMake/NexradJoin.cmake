# Joined compilation: the sources that a target has of a folder are compiled as one, so that headers are read once a
# folder and not once a file. Two of them must then not give different things the same name outside of a class.
option(VTKNexrad_JOIN_SOURCES
  "Compile the sources of each folder as one (off: file by file, which shows what a file does not include itself)" ON)

# Called when all targets are there, as folders add sources to targets of other folders.
function(nexrad_join_folders directory)
  get_property(targets DIRECTORY "${directory}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "LIBRARY|EXECUTABLE" OR type STREQUAL "INTERFACE_LIBRARY")
      continue()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${directory}" OUTPUT_VARIABLE file)
      cmake_path(GET file PARENT_PATH folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${CMAKE_SOURCE_DIR}")
      string(MAKE_C_IDENTIFIER "${folder}" folder)
      set_source_files_properties("${file}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder})
    endforeach()
  endforeach()
  get_property(folders DIRECTORY "${directory}" PROPERTY SUBDIRECTORIES)
  list(FILTER folders INCLUDE REGEX "^${CMAKE_SOURCE_DIR}/(Source/|Testing)")
  foreach(folder IN LISTS folders)
    nexrad_join_folders("${folder}")
  endforeach()
endfunction()

if(VTKNexrad_JOIN_SOURCES)
  cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL nexrad_join_folders "${CMAKE_SOURCE_DIR}")
endif()
