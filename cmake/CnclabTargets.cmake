# How this project's targets are made: warnings, sanitizers, and includes that follow the dependency table.

# Every target of ours compiles without a warning; foreign headers come in as SYSTEM.
function(cnclab_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(${target} PRIVATE -Wthread-safety)
  endif()
  if(CMAKE_UNITY_BUILD) # several files in one: what each says to itself stands beside the others
    target_compile_options(${target} PRIVATE -Wno-shadow -Wno-subobject-linkage)
  endif()
  if(CNCLAB_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${CNCLAB_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${CNCLAB_SANITIZE})
  endif()
endfunction()

# cnclab_library(NAME FOLDER SOURCES … USES …)
#
# FOLDER is the name its headers are included by: "motion" gives #include "motion/planner.hpp". The include path of
# the target shows that one folder and no other, so an include that the target does not link fails to compile.
function(cnclab_library name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  set(door ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${door})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${door}/${folder} SYMBOLIC)
  target_include_directories(${name} PUBLIC ${door})
  target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE_USES})
  cnclab_compile_options(${name})
endfunction()

# cnclab_program(NAME SOURCES … USES …): an executable in build/bin.
function(cnclab_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_USES})
  cnclab_compile_options(${name})
endfunction()

# cnclab_test(NAME SOURCES … USES …): a GoogleTest program, one ctest entry for each test case in it.
function(cnclab_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_USES} GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE CNCLAB_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}"
                                             CNCLAB_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  cnclab_compile_options(${name})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(CNCLAB_SANITIZE)
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 3")
  endif()
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()
