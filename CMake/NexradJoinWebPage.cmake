# Joins the page of nexrad_join_web_page:
#   cmake -DFOLDER=<Source/Web> -DVERSION=<of the project> -DOUTPUT=<file> -P NexradJoinWebPage.cmake
# The scripts are modules, so that each names what it uses. The page holds them one behind the other without
# "import" and "export": a page that is opened from a file may not load modules. Licence lines stand once, in
# page.html.
cmake_minimum_required(VERSION 3.22)

# The text of a file without its licence line.
function(read_text variable path)
  file(READ "${FOLDER}/${path}" text)
  string(REGEX REPLACE "[^\n]*SPDX-License-Identifier[^\n]*\n" "" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# Each stands behind those that it imports.
set(scripts vectors camera seen framing scales table bricks graphics volumePicture linePicture letters captions labels
  unpacking frame nxv remoteFile blocks brickStore brickFile series scenePicture detail viewer pointer controls main)
set(joined "")
set(seen "")
foreach(name IN LISTS scripts)
  read_text(text "Scripts/${name}.js")
  string(REGEX MATCHALL "from '\\./[A-Za-z]+\\.js'" imports "${text}")
  foreach(import IN LISTS imports)
    string(REGEX REPLACE "from '\\./([A-Za-z]+)\\.js'" "\\1" imported "${import}")
    if(NOT imported IN_LIST seen)
      message(FATAL_ERROR "Scripts/${name}.js imports ${imported}.js, which NexradJoinWebPage.cmake names later")
    endif()
  endforeach()
  string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(REGEX REPLACE "\n\n\n+" "\n\n" text "${text}")
  string(APPEND joined "${text}\n")
  list(APPEND seen ${name})
endforeach()
file(GLOB found RELATIVE "${FOLDER}/Scripts" "${FOLDER}/Scripts/*.js")
foreach(file IN LISTS found)
  string(REPLACE ".js" "" name "${file}")
  if(NOT name IN_LIST seen)
    message(FATAL_ERROR "NexradJoinWebPage.cmake does not name Scripts/${file}")
  endif()
endforeach()

set(shaders "")
file(GLOB found RELATIVE "${FOLDER}" "${FOLDER}/Shaders/*.vert" "${FOLDER}/Shaders/*.frag")
foreach(path IN LISTS found)
  read_text(text "${path}")
  get_filename_component(name "${path}" NAME)
  string(REPLACE ".vert" "Vertex" name "${name}")
  string(REPLACE ".frag" "Fragment" name "${name}")
  string(APPEND shaders "<script type=\"x-shader\" data-shader=\"${name}\">${text}</script>\n")
endforeach()

read_text(style page.css)
read_text(page page.html)
string(REPLACE "@VERSION@" "${VERSION}" page "${page}")
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SHADERS@\n" "${shaders}" page "${page}")
string(REPLACE "@SCRIPT@" "${joined}" page "${page}")
file(WRITE "${OUTPUT}" "${page}")
