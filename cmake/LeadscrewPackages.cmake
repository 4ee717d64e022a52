# Debian packages of what is installed: `cpack` in the build folder, or script/release, which also describes and signs off what
# it makes. A package holds the components of a group; what it depends on, and the files that Debian asks of each, see
# finish_packages.cmake. Where MPI, OpenCASCADE, Python or the pages are not built, there is no package of them.
if(NOT LEADSCREW_COMMAND)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME leadscrew)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(LEADSCREW_MAINTAINER "Leadscrew authors <authors@leadscrew.invalid>" CACHE STRING "who answers for the packages: whoever publishes them")
set(CPACK_PACKAGE_CONTACT ${LEADSCREW_MAINTAINER})
configure_file(${PROJECT_SOURCE_DIR}/packaging/changelog.in ${PROJECT_BINARY_DIR}/packaging/changelog @ONLY)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 1)  # of the compressor: its output does not depend on how many processors there are
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish_packages.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SOURCE leadscrew)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# leadscrew_package(GROUP NAME SECTION COMPONENTS component… [DEPENDS …] [RECOMMENDS …] [SUGGESTS …] DESCRIPTION line…): one package;
# the first line of its description is what lists of packages show.
set(CPACK_COMPONENTS_ALL "")
set(LEADSCREW_PACKAGES "")
function(leadscrew_package GROUP NAME SECTION)
  cmake_parse_arguments(PARSE_ARGV 3 package "" "" "COMPONENTS;DEPENDS;RECOMMENDS;SUGGESTS;DESCRIPTION")
  string(TOUPPER ${GROUP} id)
  set(CPACK_DEBIAN_${id}_PACKAGE_NAME ${NAME} PARENT_SCOPE)
  set(CPACK_DEBIAN_${id}_PACKAGE_SECTION ${SECTION} PARENT_SCOPE)
  foreach(kind DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN package_${kind} ", " text)
    set(CPACK_DEBIAN_${id}_PACKAGE_${kind} "${text}" PARENT_SCOPE)
  endforeach()
  list(JOIN package_DESCRIPTION "\n" text)
  set(CPACK_DEBIAN_${id}_DESCRIPTION "${text}" PARENT_SCOPE)
  foreach(component ${package_COMPONENTS})
    string(TOUPPER ${component} component_id)
    set(CPACK_COMPONENT_${component_id}_GROUP ${GROUP} PARENT_SCOPE)
  endforeach()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${package_COMPONENTS} PARENT_SCOPE)
  set(LEADSCREW_PACKAGES ${LEADSCREW_PACKAGES} ${GROUP} PARENT_SCOPE)
endfunction()

set(same_version "(= ${PROJECT_VERSION})")
set(recommended "")
set(suggested "")
if(TARGET leadscrew_mpi)
  list(APPEND suggested "leadscrew-mpi ${same_version}")
  leadscrew_package(leadscrew_mpi leadscrew-mpi science COMPONENTS mpi DEPENDS "leadscrew ${same_version}" SUGGESTS openmpi-bin
    DESCRIPTION "CNC part programs into motion: sweeps on many computers"
    "What leadscrew sweep loads when mpirun or srun has started it on several"
    "processors or computers, so that they share the work.")
endif()
if(TARGET leadscrew_exchange_program)
  list(APPEND suggested "leadscrew-exchange ${same_version}")
  leadscrew_package(leadscrew_exchange leadscrew-exchange science COMPONENTS exchange DEPENDS "leadscrew ${same_version}"
    DESCRIPTION "CNC part programs into motion: surfaces from STEP and IGES"
    "What leadscrew surfaces starts to read the faces of STEP and IGES files as"
    "surfaces of a part program. It stands on OpenCASCADE.")
endif()
if(TARGET leadscrew_server AND EXISTS ${PROJECT_SOURCE_DIR}/build/web/page/index.html)
  list(APPEND recommended "leadscrew-web ${same_version}")
  leadscrew_package(leadscrew_web leadscrew-web science COMPONENTS web DEPENDS "leadscrew ${same_version}"
    DESCRIPTION "CNC part programs into motion: the workbench in a browser"
    "Pages that show the path of a part program, its motion and where its time"
    "goes, and that step interpolators register by register. leadscrew serve gives"
    "them to the browsers of this machine, and leadscrew run --report writes such a"
    "page with a motion in it.")
endif()
leadscrew_package(leadscrew leadscrew science COMPONENTS command pages RECOMMENDS ${recommended} SUGGESTS ${suggested}
  DESCRIPTION "CNC part programs into motion"
  "Leadscrew turns part programs (G-code) into motion: one position for each axis"
  "at every servo period, with velocity, acceleration and jerk of every axis"
  "inside its limits, as fast as these allow. An independent referee measures"
  "every run."
  "It also checks and explains programs, simulates drives, sweeps archives of"
  "programs, and interpolates in single steps by the published methods."
  "."
  "This package has the command, machine files and example programs.")
set(version_of_interface ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
leadscrew_package(libleadscrew libleadscrew${version_of_interface} libs COMPONENTS library
  DESCRIPTION "CNC part programs into motion: the library for C"
  "Leadscrew turns part programs and moves into one position for each axis at"
  "every servo period, inside limits of velocity, acceleration and jerk."
  "."
  "This package has the shared library behind leadscrew.h.")
leadscrew_package(libleadscrew_dev libleadscrew-dev libdevel COMPONENTS development
  DEPENDS "libleadscrew${version_of_interface} ${same_version}" libexpected-dev libfast-float-dev libfmt-dev libtomlplusplus-dev
  SUGGESTS cmake pkg-config
  DESCRIPTION "CNC part programs into motion: headers and archives"
  "To build motion into a controller or another program: leadscrew.h for C with"
  "the shared library, the headers of the C++ library with static archives, files"
  "for CMake's find_package(leadscrew) and for pkg-config, and examples.")

if(TARGET leadscrew_python)
  execute_process(COMMAND /usr/bin/python3 -c "import sys; print('(>= 3.%d);(<< 3.%d)' % (sys.version_info[1], sys.version_info[1] + 1))"
    OUTPUT_VARIABLE versions OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  list(TRANSFORM versions PREPEND "python3 ")
  leadscrew_package(python3_leadscrew python3-leadscrew python COMPONENTS python DEPENDS ${versions} python3-numpy
    SUGGESTS python3-matplotlib
    DESCRIPTION "CNC part programs into motion: the package for Python"
    "Motion of part programs and of paths from arrays as arrays of NumPy, with the"
    "referee that judges any trace, simulated drives, kinematics, surfaces and the"
    "interpolators of reference pulses.")
  set(CPACK_DEBIAN_PYTHON3_LEADSCREW_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/python3/postinst
    ${PROJECT_SOURCE_DIR}/packaging/python3/prerm)
endif()

# All that the packages hold.
add_custom_target(packaged)
add_dependencies(packaged leadscrew_command ${targets} ${room_targets})
foreach(target leadscrew_python leadscrew_pages leadscrew_server leadscrew_mpi leadscrew_exchange_program)
  if(TARGET ${target})
    add_dependencies(packaged ${target})
  endif()
endforeach()

# What finish_packages.cmake needs to know, as cpack reads it.
set(CPACK_LEADSCREW_PACKAGES ${LEADSCREW_PACKAGES})
set(CPACK_LEADSCREW_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_LEADSCREW_CHANGELOG ${PROJECT_BINARY_DIR}/packaging/changelog)
set(CPACK_LEADSCREW_INTERFACE ${version_of_interface})
include(CPack)
