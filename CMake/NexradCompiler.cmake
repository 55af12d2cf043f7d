# Language level, warnings and sanitisers, in one place.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(VTKNexrad_CCACHE ccache)
mark_as_advanced(VTKNexrad_CCACHE)
if(VTKNexrad_CCACHE AND NOT DEFINED ENV{CCACHE_DISABLE})
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VTKNexrad_CCACHE}")
  # The cache takes the place of precompiled headers, and shows where a source leans on what they include.
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

if(VTKNexrad_SANITIZE)
  add_compile_options("-fsanitize=${VTKNexrad_SANITIZE}" -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${VTKNexrad_SANITIZE}")
  if(VTKNexrad_SANITIZE_WITHOUT)
    add_compile_options("-fno-sanitize=${VTKNexrad_SANITIZE_WITHOUT}")
  endif()
endif()

# Targets of this project call this; code of other projects is not held to our warnings.
function(nexrad_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wold-style-cast>
    # Where files are joined, a name outside of functions is seen by the files after its own.
    $<$<COMPILE_LANGUAGE:CXX>:$<IF:$<BOOL:${VTKNexrad_JOIN_SOURCES}>,-Wno-subobject-linkage,-Wshadow>>
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${VTKNexrad_STRICT}>>:-Werror>)
endfunction()

# The same for a VTK module. VTK's type macro ends in "public:", so the semicolon that every VTK class
# writes after it is one too many for -Wpedantic: in the module, and for those who include its classes.
function(nexrad_module_warnings target)
  nexrad_warnings(${target})
  target_compile_options(${target} PRIVATE -Wno-pedantic)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  set_property(TARGET ${target} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${folders})
endfunction()
