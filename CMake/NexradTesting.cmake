include(GoogleTest)

# nexrad_add_test(<name> SOURCES <file>... [LIBRARIES <target>...] [LABEL <label>] [TIMEOUT <s>]
#   [TOGETHER|APART] [LOCK <what>] [NOT_SANITIZED <filter>])
#
# One GoogleTest program. CTest runs each of its tests in a process of its own; with TOGETHER it runs them all
# in one, so that they share what they simulate. It does so with all programs whose label VTKNexrad_TESTS_TOGETHER
# names and that are not to stay APART: processes take long to start under the sanitisers, and where they draw.
# Labels: "quick" (the default), "display" needs an X server, "slow" is neither built nor run under the sanitisers.
# NOT_SANITIZED names tests of others, as --gtest_filter does, that do not run there: they take long, and the code that
# they run is that of tests which do. With VTKNexrad_REPEAT_SANITIZED off, a build without sanitisers has of Core only
# what these leave out: the slow tests, and those of NOT_SANITIZED.
# CTest never runs two tests at once whose programs LOCK the same thing, as "screen": its keyboard goes to one window.
function(nexrad_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "TOGETHER;APART" "TIMEOUT;LABEL;LOCK;NOT_SANITIZED" "SOURCES;LIBRARIES")
  # Those that take long start first, so that none of them runs alone in the end; before them those that wait for each
  # other.
  set(cost 10)
  if(arg_LOCK)
    set(cost 1000)
  elseif(arg_TIMEOUT)
    set(cost ${arg_TIMEOUT})
  elseif(arg_LABEL STREQUAL "display")
    set(cost 200)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  if(NOT arg_LABEL)
    set(arg_LABEL quick)
  endif()
  add_executable(${name} ${arg_SOURCES})
  nexrad_warnings(${name})
  # What is tested is optimised as users have it; the tests themselves compile in two thirds of the time of -O1.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-Og>)
  if(VTKNexrad_SANITIZE MATCHES "undefined") # a fifth of the time of compiling, for checks that matter to decoders
    target_compile_options(${name} PRIVATE -fno-sanitize=vptr,alignment)
  endif()
  target_link_libraries(${name} PRIVATE NexradTestSupport ${arg_LIBRARIES} GTest::gtest_main)
  # One file for all of them; the first is the owner.
  if(name STREQUAL "TestTestSupport")
    target_precompile_headers(${name} PRIVATE "${CMAKE_SOURCE_DIR}/Testing/Support/PrecompiledHeaders.h")
  else()
    target_precompile_headers(${name} REUSE_FROM TestTestSupport)
  endif()
  target_compile_definitions(${name} PRIVATE
    NEXRAD_BASELINE_DIR="${CMAKE_SOURCE_DIR}/Testing/Baseline"
    NEXRAD_TEST_OUTPUT_DIR="${CMAKE_BINARY_DIR}/Testing/Output")
  if(arg_LABEL IN_LIST VTKNexrad_TESTS_TOGETHER AND NOT arg_APART)
    set(arg_TOGETHER ON)
    set(arg_TIMEOUT 900)
  endif()
  set(filter "*")
  if(VTKNexrad_SANITIZE)
    set(filter "*-${arg_NOT_SANITIZED}")
    if(arg_LABEL STREQUAL "slow")
      set(filter "")
    endif()
  elseif(nexrad_sanitized_elsewhere AND NOT arg_LABEL STREQUAL "slow")
    set(filter "${arg_NOT_SANITIZED}")
  endif()
  if(filter STREQUAL "")
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  set(properties TIMEOUT ${arg_TIMEOUT} LABELS ${arg_LABEL} COST ${cost})
  if(arg_LOCK)
    list(APPEND properties RESOURCE_LOCK ${arg_LOCK})
  endif()
  if(arg_TOGETHER)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1 "--gtest_filter=${filter}") # prints the tests that fail
    set_tests_properties(${name} PROPERTIES ${properties})
  else()
    gtest_discover_tests(${name} TEST_FILTER "${filter}"
      DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  endif()
endfunction()
