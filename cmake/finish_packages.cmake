# Read by cpack between installing into a folder for each package and packing these. Adds what Debian asks of every package
# (changelog, copyright), compresses manual pages, finds dependencies by dpkg-shlibdeps, and gives every file the time of the last
# commit, so that the same sources make the same packages.
set(stage ${CPACK_TOPLEVEL_DIRECTORY}/${CPACK_PACKAGE_FILE_NAME})
set(source ${CPACK_LEADSCREW_SOURCE})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}${error}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Without git, the time is that of the changelog's last entry.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C ${source} log -1 --format=%ct RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    run(dpkg-parsechangelog -l ${CPACK_LEADSCREW_CHANGELOG} -S Timestamp)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${output})
endif()

# Into `dependencies`: packages that the programs and libraries below FOLDER need.
function(shared_libraries FOLDER)
  set(dependencies "" PARENT_SCOPE)
  run(find ${FOLDER}/usr -type f "(" -path "*/bin/*" -o -path "*/libexec/*" -o -name "*.so*" ")")
  if(output STREQUAL "")
    return()
  endif()
  string(REPLACE "\n" ";" binaries "${output}")
  set(scratch ${CPACK_TOPLEVEL_DIRECTORY}/dependencies)
  file(WRITE ${scratch}/debian/control "")
  execute_process(COMMAND dpkg-shlibdeps -O ${binaries} WORKING_DIRECTORY ${scratch} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE error OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "dpkg-shlibdeps ${binaries}\n${error}")
  endif()
  string(REGEX REPLACE "^.*shlibs:Depends=" "" output "${output}")
  set(dependencies "${output}" PARENT_SCOPE)
endfunction()

function(finish FOLDER PACKAGE)
  set(documents ${FOLDER}/usr/share/doc/${PACKAGE})
  file(COPY ${CPACK_LEADSCREW_CHANGELOG} DESTINATION ${documents})
  run(/usr/bin/python3 ${source}/packaging/contents.py copyright ${PACKAGE} ${documents}/copyright)
  run(chmod 644 ${documents}/changelog ${documents}/copyright)
  if(EXISTS ${source}/packaging/overrides/${PACKAGE})
    file(COPY ${source}/packaging/overrides/${PACKAGE} DESTINATION ${FOLDER}/usr/share/lintian/overrides)
    run(chmod 644 ${FOLDER}/usr/share/lintian/overrides/${PACKAGE})
  endif()
  # Where the linker of MPI or of another library has left a path to it, the system's own is meant.
  file(GLOB modules ${FOLDER}/usr/lib/leadscrew/*.so)
  foreach(module ${modules})
    file(RPATH_REMOVE FILE ${module})
  endforeach()
  run(find ${FOLDER} -path "*/man/man1/*.1" -exec gzip -9n {} +)
  run(gzip -9n ${documents}/changelog)
  run(find ${FOLDER} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +)
endfunction()

foreach(group ${CPACK_LEADSCREW_PACKAGES})
  string(TOUPPER ${group} id)
  finish(${stage}/${group} ${CPACK_DEBIAN_${id}_PACKAGE_NAME})
  shared_libraries(${stage}/${group})
  if(dependencies)
    list(APPEND CPACK_DEBIAN_${id}_PACKAGE_DEPENDS ${dependencies})
    list(JOIN CPACK_DEBIAN_${id}_PACKAGE_DEPENDS ", " CPACK_DEBIAN_${id}_PACKAGE_DEPENDS)
  endif()
endforeach()

# Who links the shared library depends on its package; the linker's cache is told of it by dpkg.
set(control ${CPACK_TOPLEVEL_DIRECTORY}/control)
file(WRITE ${control}/shlibs
  "libleadscrew ${CPACK_LEADSCREW_INTERFACE} ${CPACK_DEBIAN_LIBLEADSCREW_PACKAGE_NAME} (>= ${CPACK_PACKAGE_VERSION})\n")
file(WRITE ${control}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBLEADSCREW_PACKAGE_CONTROL_EXTRA "${control}/shlibs;${control}/triggers")
