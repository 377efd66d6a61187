# What `cmake --install` does, and `cmake --build build --target package`; the package of the build folder.

# ---- package of CMake -----------------------------------------------------------------------------

set(targets passive_haptics passive_haptics_driver passive_haptics_device_file passive_haptics_testing passive_haptics_interop)
# A target of the parent project itself may be in no export set, which would be an error here
get_target_property(eigen_imported Eigen3::Eigen IMPORTED)
get_target_property(boost_imported Boost::headers IMPORTED)
if(eigen_imported AND boost_imported)
  export(TARGETS ${targets} NAMESPACE passive_haptics:: FILE passive_haptics-targets.cmake)
endif()

file(CONFIGURE OUTPUT passive_haptics-config.cmake @ONLY CONTENT [[
if(TARGET passive_haptics::passive_haptics)
  get_property(passive_haptics_present TARGET passive_haptics::passive_haptics PROPERTY PASSIVE_HAPTICS_VERSION)
  if(NOT passive_haptics_present STREQUAL "@PROJECT_VERSION@")
    set(passive_haptics_FOUND FALSE)
    set(passive_haptics_NOT_FOUND_MESSAGE "passive_haptics = '${passive_haptics_present}': expected @PROJECT_VERSION@, which ${CMAKE_CURRENT_LIST_DIR} has; find or add one version only")
    return()
  endif()
endif()

include(CMakeFindDependencyMacro)
if(NOT TARGET Eigen3::Eigen)
  find_dependency(Eigen3 NO_MODULE)
endif()
if(DEFINED Eigen3_VERSION AND Eigen3_VERSION VERSION_LESS 3.4)
  set(passive_haptics_FOUND FALSE)
  set(passive_haptics_NOT_FOUND_MESSAGE "Eigen = ${Eigen3_VERSION}: expected Eigen 3.4 or newer; set Eigen3_DIR, now ${Eigen3_DIR}")
  return()
endif()
if(NOT TARGET Boost::headers)
  find_dependency(Boost 1.74)
endif()
if(DEFINED Boost_VERSION AND Boost_VERSION VERSION_LESS 1.74)
  set(passive_haptics_FOUND FALSE)
  set(passive_haptics_NOT_FOUND_MESSAGE "Boost = ${Boost_VERSION}: expected Boost 1.74 or newer; set Boost_DIR, now ${Boost_DIR}")
  return()
endif()
if("testing" IN_LIST passive_haptics_FIND_COMPONENTS AND NOT TARGET GTest::gtest)
  find_dependency(GTest)
endif()
if("device_file" IN_LIST passive_haptics_FIND_COMPONENTS AND NOT TARGET tomlplusplus::tomlplusplus)
  find_dependency(tomlplusplus)
endif()
if("driver" IN_LIST passive_haptics_FIND_COMPONENTS)
  find_dependency(Threads)
endif()

include("${CMAKE_CURRENT_LIST_DIR}/passive_haptics-targets.cmake")

foreach(component IN LISTS passive_haptics_FIND_COMPONENTS)
  if(TARGET passive_haptics::${component})
    set(passive_haptics_${component}_FOUND TRUE)
  elseif(passive_haptics_FIND_REQUIRED_${component})
    set(passive_haptics_FOUND FALSE)
    set(passive_haptics_NOT_FOUND_MESSAGE "passive_haptics has no component '${component}'")
  endif()
endforeach()
]])
# One version accepts the later ones of its minor version, a range accepts what it contains.
file(CONFIGURE OUTPUT passive_haptics-config-version.cmake @ONLY CONTENT [[
set(PACKAGE_VERSION @PROJECT_VERSION@)
set(PACKAGE_VERSION_COMPATIBLE FALSE)
if(PACKAGE_FIND_VERSION_RANGE)
  if(PACKAGE_VERSION VERSION_GREATER_EQUAL PACKAGE_FIND_VERSION_MIN AND (PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION_MAX
      OR (PACKAGE_FIND_VERSION_RANGE_MAX STREQUAL "INCLUDE" AND PACKAGE_VERSION VERSION_EQUAL PACKAGE_FIND_VERSION_MAX)))
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
  endif()
elseif(PACKAGE_VERSION VERSION_EQUAL PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
elseif(PACKAGE_VERSION VERSION_GREATER PACKAGE_FIND_VERSION
    AND PACKAGE_FIND_VERSION VERSION_GREATER_EQUAL @PROJECT_VERSION_MAJOR@.@PROJECT_VERSION_MINOR@)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
]])

if(NOT PASSIVE_HAPTICS_INSTALL)
  return()
endif()

# ---- installation ---------------------------------------------------------------------------------

include(GNUInstallDirs)
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/passive_haptics)

# Folders first, for all to enter: CMake makes those that are missing by the umask, which may keep others out.
function(passive_haptics_folders component)
  install(CODE "
    set(folders)
    foreach(folder IN ITEMS ${ARGN})
      cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY \"\${CMAKE_INSTALL_PREFIX}\")
      list(APPEND folders \"\$ENV{DESTDIR}\${folder}\")
    endforeach()
    if(UNIX)
      execute_process(COMMAND sh -c [[umask 022 && mkdir -p \"$@\"]] sh \${folders} COMMAND_ERROR_IS_FATAL ANY)
    endif()" COMPONENT ${component})
endfunction()
file(GLOB_RECURSE folders RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/include LIST_DIRECTORIES true include/*)
list(FILTER folders EXCLUDE REGEX "[.]hpp$")
list(TRANSFORM folders PREPEND ${CMAKE_INSTALL_INCLUDEDIR}/)
passive_haptics_folders(Unspecified ${folders} ${package_dir} ${CMAKE_INSTALL_DATADIR}/pkgconfig)
passive_haptics_folders(licence ${CMAKE_INSTALL_DOCDIR})

install(TARGETS ${targets} EXPORT passive_haptics FILE_SET HEADERS
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})  # for Meson, which does not read file sets
install(EXPORT passive_haptics NAMESPACE passive_haptics:: FILE passive_haptics-targets.cmake
  DESTINATION ${package_dir})

install(FILES
  ${PROJECT_BINARY_DIR}/passive_haptics-config.cmake
  ${PROJECT_BINARY_DIR}/passive_haptics-config-version.cmake
  DESTINATION ${package_dir})

# Relative to the .pc file, so that an installed tree can be moved.
file(RELATIVE_PATH pc_to_include
  ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
# Eigen's own file passes -I, and its warnings would reach the user. A folder that is given both ways counts as
# one of the system. Of a target of the project itself the folders are those of a build, and stay out; those of
# others may be generator expressions. Folders that the compiler searches anyway must keep its order.
string(REGEX REPLACE "[^;/A-Za-z0-9_-]" "." implicit "${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}")
list(JOIN implicit "|" implicit)
set(folders)
foreach(target IN ITEMS Eigen3::Eigen Boost::headers)
  get_target_property(imported ${target} IMPORTED)
  if(imported)
    list(APPEND folders $<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>)
  endif()
endforeach()
set(folders "$<FILTER:${folders},EXCLUDE,^(|${implicit})$>")
set(system_flags "$<$<BOOL:${folders}>: -isystem $<JOIN:${folders}, -isystem >>")
string(CONFIGURE [[
includedir=${pcfiledir}/@pc_to_include@

Name: @PROJECT_NAME@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Requires: eigen3 >= 3.4
Cflags: -I${includedir}@system_flags@
]] pc @ONLY)
set(pc_file ${PROJECT_BINARY_DIR}/pkgconfig/$<CONFIG>/passive_haptics.pc)
file(GENERATE OUTPUT ${pc_file} CONTENT "${pc}")
install(FILES ${pc_file} DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)

# ---- Debian package -------------------------------------------------------------------------------

# Its changelog and its maintainer are of the commit that it is made from.
if(PROJECT_IS_TOP_LEVEL)
  execute_process(COMMAND git log -1 "--format=  * Version ${PROJECT_VERSION}, commit %h.%n%n -- %an <%ae>  %cD"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE change ERROR_QUIET)
  if(NOT change)
    message(STATUS "No commit of git: without the Debian package")
  endif()
endif()
if(change)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME libpassive-haptics-dev)
  string(REGEX REPLACE ".* -- (.*>).*" "\\1" CPACK_PACKAGE_CONTACT "${change}")
  set(CPACK_PACKAGE_DESCRIPTION "Headers for haptic devices that have brakes instead of motors: the forces
that they can make, the nearest to a desired one, and control laws.")
  set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libboost-dev (>= 1.74)")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  # Whatever the umask is, all may enter its folders
  file(CONFIGURE OUTPUT open_folders.cmake @ONLY CONTENT [[
file(CHMOD_RECURSE ${CPACK_TEMPORARY_INSTALL_DIRECTORY} DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
]])
  set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_BINARY_DIR}/open_folders.cmake)

  set(release ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
  file(CONFIGURE OUTPUT changelog @ONLY CONTENT
    "@CPACK_PACKAGE_NAME@ (@release@) unstable; urgency=medium\n\n@change@")
  execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/changelog
    OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.Debian.gz COMMAND_ERROR_IS_FATAL ANY)

  # What Debian expects instead of LICENSE is in a component of its own, which no other installation contains.
  set(of_debian DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME} COMPONENT debian EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian.gz ${of_debian})
  install(FILES LICENSE RENAME copyright ${of_debian})
  set(CPACK_COMPONENTS_ALL Unspecified debian)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  include(CPack)
endif()
