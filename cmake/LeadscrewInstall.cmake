# `cmake --install`, and find_package(leadscrew): leadscrew::leadscrew for those who build on the library, with
# leadscrew::realtime and leadscrew::config beside it, and for those who call leadscrew.h leadscrew::shared or, in a program
# of rooms, leadscrew::capi. pkg-config knows the first as leadscrew-cpp, the shared library as leadscrew.
# Headers: those of include/leadscrew, and what they need, as internal (install_headers.cmake).
# What is installed comes in components, of which LeadscrewPackages.cmake makes packages.
include(CMakePackageConfigHelpers)

set(rooms ${LEADSCREW_LIBRARY_ROOMS})
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/leadscrew/*.hpp)
if(LEADSCREW_COMMAND)
  list(APPEND rooms realtime config)
  list(APPEND targets leadscrew_pulse leadscrew_gouging leadscrew_nc leadscrew_servo leadscrew_markup leadscrew_waves leadscrew_language leadscrew_capi leadscrew_shared)  # leadscrew.h stands on the first seven
  file(GLOB c_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/leadscrew/capi/leadscrew*.h)  # leadscrew.h includes the others
  install(FILES ${c_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
else()
  list(FILTER headers EXCLUDE REGEX "/(files|realtime)\\.hpp$")
endif()
list(TRANSFORM rooms PREPEND leadscrew_ OUTPUT_VARIABLE room_targets)
install(CODE "set(PUBLIC \"${headers};${PROJECT_BINARY_DIR}/include/leadscrew/version.hpp\")
set(SOURCES \"${PROJECT_SOURCE_DIR}/src\")
set(STAGE \"${PROJECT_BINARY_DIR}/installed_headers\")
set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")" COMPONENT development)
install(SCRIPT cmake/install_headers.cmake COMPONENT development)
install(TARGETS ${targets} ${room_targets} leadscrew_all EXPORT leadscrew
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT leadscrew NAMESPACE leadscrew:: FILE leadscrew-targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew COMPONENT development)

configure_package_config_file(cmake/leadscrew-config.cmake.in ${CMAKE_BINARY_DIR}/leadscrew-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/leadscrew-config.cmake ${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew COMPONENT development)

# For pkg-config, archives stand in the order in which a linker reads them: before those that they need.
set(LEADSCREW_ARCHIVES ${LEADSCREW_LIBRARY_ROOMS})
list(REVERSE LEADSCREW_ARCHIVES)
list(TRANSFORM LEADSCREW_ARCHIVES PREPEND "-lleadscrew_")
list(JOIN LEADSCREW_ARCHIVES " " LEADSCREW_ARCHIVES)
file(RELATIVE_PATH LEADSCREW_PREFIX_FROM_PKGCONFIG ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" LEADSCREW_PREFIX_FROM_PKGCONFIG "${LEADSCREW_PREFIX_FROM_PKGCONFIG}")
set(known leadscrew-cpp)
if(LEADSCREW_COMMAND)
  list(APPEND known leadscrew)
endif()
foreach(name ${known})
  configure_file(cmake/${name}.pc.in ${CMAKE_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()

# Machines and programs to begin with, and programs that call the library.
if(LEADSCREW_COMMAND)
  install(DIRECTORY machines DESTINATION ${CMAKE_INSTALL_DATADIR}/leadscrew COMPONENT command FILES_MATCHING PATTERN "*.toml")
  file(GLOB programs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.ngc)
  install(FILES ${programs} examples/tools.tbl DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/leadscrew/examples COMPONENT command)
endif()
install(DIRECTORY examples/c examples/controller examples/controller-on-time examples/host
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libleadscrew-dev/examples COMPONENT development
  FILES_MATCHING REGEX "\\.(c|cpp|hpp|h)$|CMakeLists\\.txt$")

# For Debian's Python, where its package has them; pip installs its own (python/setup.py).
if(TARGET leadscrew_python)
  set(python lib/python3/dist-packages/leadscrew)
  install(TARGETS leadscrew_python LIBRARY DESTINATION ${python} COMPONENT python EXCLUDE_FROM_ALL)
  file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/leadscrew/*.py ${PROJECT_SOURCE_DIR}/python/leadscrew/*.pyi)
  install(FILES ${modules} python/leadscrew/py.typed DESTINATION ${python} COMPONENT python EXCLUDE_FROM_ALL)
  file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/examples/*.py)
  install(FILES ${scripts} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-leadscrew/examples COMPONENT python EXCLUDE_FROM_ALL)
endif()
include(LeadscrewPackages)
