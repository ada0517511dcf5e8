# SPDX-License-Identifier: MIT
# How every library, program and unit test of the project is declared: one standard, one set of warnings.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(gnomon_options INTERFACE)
# No contraction: a fused multiply-add would make the C++ build of a shader module differ from the GPU.
target_compile_options(gnomon_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off)
# g++ 12 counts a member that a designated initializer leaves at its default as forgotten; it is what they are for.
target_compile_options(gnomon_options INTERFACE -Wno-missing-field-initializers)
# ... and sees overlapping copies in `"text" + std::string` where there are none (GCC bug 105651).
target_compile_options(gnomon_options INTERFACE -Wno-restrict)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(gnomon_options INTERFACE -Werror)
endif()
if(GNOMON_SANITIZE)
  target_compile_options(gnomon_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  # Under instrumentation g++ takes the standard library's own regular expressions for uninitialized.
  target_compile_options(gnomon_options INTERFACE -Wno-maybe-uninitialized)
  target_link_options(gnomon_options INTERFACE -fsanitize=address,undefined)
endif()

# For code that reads, writes and decides but does not calculate: half the time to compile, and none lost when it runs.
add_library(gnomon_quick_to_compile INTERFACE)
target_compile_options(gnomon_quick_to_compile INTERFACE $<$<CONFIG:Release>:-O1>)

# gnomon_library(NAME name [QUICK] SOURCES ... [PUBLIC libs...] [PRIVATE libs...])
# QUICK: compile for quick builds, it does not calculate. Makes gnomon::name from gnomon_name; headers are found from the folder above runner/ subfolders ("scene/scene.h").
function(gnomon_library)
  cmake_parse_arguments(arg "QUICK" "NAME" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(gnomon_${arg_NAME} STATIC ${arg_SOURCES})
  add_library(gnomon::${arg_NAME} ALIAS gnomon_${arg_NAME})
  target_link_libraries(gnomon_${arg_NAME} PUBLIC ${arg_PUBLIC}
                                              PRIVATE $<BUILD_INTERFACE:gnomon_options> ${arg_PRIVATE})
  if(arg_QUICK)
    target_link_libraries(gnomon_${arg_NAME} PRIVATE $<BUILD_INTERFACE:gnomon_quick_to_compile>)
  endif()
endfunction()

# gnomon_unit_test(NAME name SOURCES ... LIBS ...): one GoogleTest program, known to CTest as one entry.
function(gnomon_unit_test)
  cmake_parse_arguments(arg "" "NAME" "SOURCES;LIBS" ${ARGN})
  if(NOT BUILD_TESTING)
    return()
  endif()
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE gnomon_options gnomon_quick_to_compile ${arg_LIBS} GTest::gtest GTest::gtest_main)
  set_target_properties(${arg_NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  add_test(NAME ${arg_NAME} COMMAND ${arg_NAME})
  set_tests_properties(${arg_NAME} PROPERTIES TIMEOUT 600)
endfunction()
