# `cmake --install`, and find_package(leadscrew) for those who build on the rooms of the core, or on those, realtime and config, and for those who
# call leadscrew.h, with leadscrew::shared or, in a program of rooms, with leadscrew::capi.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY LEADSCREW_CORE_ROOMS)
if(LEADSCREW_COMMAND)
  list(APPEND rooms realtime config)
  list(APPEND targets leadscrew_capi leadscrew_shared)
  install(FILES src/leadscrew/capi/leadscrew.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
foreach(room ${rooms})
  list(APPEND targets leadscrew_${room})
  install(DIRECTORY src/leadscrew/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/leadscrew FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(TARGETS ${targets} leadscrew_all EXPORT leadscrew ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT leadscrew NAMESPACE leadscrew:: FILE leadscrew-targets.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)

configure_package_config_file(cmake/leadscrew-config.cmake.in ${CMAKE_BINARY_DIR}/leadscrew-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/leadscrew-config.cmake ${CMAKE_BINARY_DIR}/leadscrew-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/leadscrew)
