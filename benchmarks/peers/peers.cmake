# The peers of benchmark_peers. None is part of this repository: each is compared where CMake finds it (a system package,
# CMAKE_PREFIX_PATH) and named as absent by the program elsewhere.
set(absent)

# peer(SOURCE NAME PACKAGE LIBRARY...): adds peers/solvers/SOURCE.cpp where PACKAGE was found. An object library of its own, so
# that no peer's options reach another's code or ours.
macro(peer source name package)
  if(${package}_FOUND)
    string(STRIP "${name} ${${package}_VERSION}" solver)
    add_library(peer_${source} OBJECT peers/solvers/${source}.cpp)
    target_compile_definitions(peer_${source} PRIVATE PEER="${solver}")
    target_include_directories(peer_${source} SYSTEM PRIVATE ${${package}_INCLUDE_DIR} ${${package}_INCLUDE_DIRS})
    target_link_libraries(peer_${source} PRIVATE ${ARGN})
    target_link_libraries(benchmark_peers PRIVATE peer_${source})
  else()
    list(APPEND absent "${name}")
  endif()
endmacro()

get_target_property(eigen_directories Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
foreach(directory IN LISTS eigen_directories)
  if(EXISTS ${directory}/unsupported/Eigen/NNLS)
    set(NNLS_FOUND TRUE)
    set(NNLS_VERSION ${Eigen3_VERSION})
  endif()
endforeach()
peer(eigen_nnls "Eigen NNLS" NNLS)

find_package(daqp QUIET)
peer(daqp DAQP daqp daqpstat)

find_package(eiquadprog QUIET)
peer(eiquadprog eiquadprog eiquadprog eiquadprog::eiquadprog)

find_package(orocos_kdl QUIET)
peer(kdl KDL orocos_kdl ${orocos_kdl_LIBRARIES})

find_package(pinocchio QUIET)
peer(pinocchio Pinocchio pinocchio pinocchio::pinocchio)

list(JOIN absent ", " absent)
if(NOT absent)
  set(absent none)
endif()
target_compile_definitions(benchmark_peers PRIVATE PEERS_ABSENT="${absent}")
