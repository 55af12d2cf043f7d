# nexrad_join_web_page(<target> <symbol>)
#
# Joins the files of Source/Web into one page and compiles it into <target>, as nexrad_embed does. What a
# command fills in stays: @TITLE@ and @PARTS@.
set(nexrad_web_page_script "${CMAKE_CURRENT_LIST_DIR}/NexradJoinWebPage.cmake")
function(nexrad_join_web_page target symbol)
  set(folder "${PROJECT_SOURCE_DIR}/Source/Web")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*")
  set(page "${CMAKE_CURRENT_BINARY_DIR}/page.html")
  add_custom_command(OUTPUT "${page}"
    COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${folder}" "-DOUTPUT=${page}" "-DVERSION=${PROJECT_VERSION}"
      -P "${nexrad_web_page_script}"
    DEPENDS ${sources} "${nexrad_web_page_script}"
    COMMENT "Joining the page of nexrad3d web"
    VERBATIM)
  nexrad_embed(${target} "${page}" ${symbol})
endfunction()
