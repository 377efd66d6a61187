# The target all_verify_interface_header_sets compiles each header alone, with our warnings, except those that need a library
# which is missing: tests/interop compiles the headers of interop/, a benchmark latency_of.hpp.
include(${CMAKE_CURRENT_LIST_DIR}/../warnings.cmake)
find_package(benchmark QUIET)
set_target_properties(passive_haptics_interop PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
if(NOT TARGET GTest::gtest OR NOT TARGET benchmark::benchmark)
  set_target_properties(passive_haptics_testing PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
endif()
add_compile_options($<TARGET_PROPERTY:passive_haptics_warnings,INTERFACE_COMPILE_OPTIONS> -Wsign-conversion)
# Eigen takes two thirds of their time, and only one header includes it: clang++ reads it once
if(PASSIVE_HAPTICS_BATCH_TESTS AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  set(read_once ${PROJECT_BINARY_DIR}/read_once.hpp)
  file(WRITE ${read_once} "#include <Eigen/Core>\n#include <boost/hana/basic_tuple.hpp>\n")
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM eigen PREPEND -isystem)
  string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${${flags}}")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -DBOOST_ALL_NO_LIB ${flags} ${eigen}
    -x c++-header ${read_once} -o ${read_once}.pch RESULT_VARIABLE failed)
  if(NOT failed)
    add_compile_options(-include-pch ${read_once}.pch)
  endif()
endif()
