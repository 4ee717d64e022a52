# `cmake --install`, and find_package(leadscrew): leadscrew::leadscrew for those who build on the library, with
# leadscrew::realtime and leadscrew::config beside it, and for those who call leadscrew.h leadscrew::shared or, in a program
# of rooms, leadscrew::capi. Headers: those of include/leadscrew, and what they need, as internal (install_headers.cmake).
include(CMakePackageConfigHelpers)

set(rooms ${LEADSCREW_LIBRARY_ROOMS})
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/leadscrew/*.hpp)
if(LEADSCREW_COMMAND)
  list(APPEND rooms realtime config)
  list(APPEND targets leadscrew_pulse leadscrew_gouging leadscrew_nc leadscrew_servo leadscrew_language leadscrew_capi leadscrew_shared)  # leadscrew.h stands on the first five
  install(FILES src/leadscrew/capi/leadscrew.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
else()
  list(FILTER headers EXCLUDE REGEX "/(files|realtime)\\.hpp$")
endif()
list(TRANSFORM rooms PREPEND leadscrew_ OUTPUT_VARIABLE room_targets)
install(CODE "set(PUBLIC \"${headers};${PROJECT_BINARY_DIR}/include/leadscrew/version.hpp\")
set(SOURCES \"${PROJECT_SOURCE_DIR}/src\")
set(STAGE \"${PROJECT_BINARY_DIR}/installed_headers\")
set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")")
install(SCRIPT cmake/install_headers.cmake)
install(TARGETS ${targets} ${room_targets} leadscrew_all EXPORT leadscrew ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT leadscrew NAMESPACE leadscrew:: FILE leadscrew-targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)

configure_package_config_file(cmake/leadscrew-config.cmake.in ${CMAKE_BINARY_DIR}/leadscrew-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/leadscrew-config.cmake ${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)
