# Installs the public headers, include/leadscrew/NAME.hpp, and of the rooms' headers those that these need, directly or
# not, as include/leadscrew/internal/ROOM/NAME.hpp: no path of one says otherwise than that it is internal, and none is
# there that no public header leads to. In the sources and here the same text stands for both but for that path.
#   PUBLIC      public headers        SOURCES      folder of the rooms' <leadscrew/ROOM/NAME.hpp>
#   DESTINATION where to, less leadscrew/          STAGE        a folder of the build for what is to be installed

# Writes a header with the paths of the rooms' headers that it includes, which are appended to `found`.
function(stage HEADER NAME)
  file(READ ${HEADER} text)
  string(REGEX MATCHALL "#include <leadscrew/[a-z_]+/[a-z_0-9]+\\.hpp>" includes "${text}")
  list(TRANSFORM includes REPLACE "#include <leadscrew/(.*)>" "\\1")
  string(REGEX REPLACE "#include <leadscrew/([a-z_]+/)" "#include <leadscrew/internal/\\1" text "${text}")
  file(WRITE ${STAGE}/leadscrew/${NAME} "${text}")
  set(found ${found} ${includes} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${STAGE})
set(found "")
foreach(header ${PUBLIC})
  get_filename_component(name ${header} NAME)
  stage(${header} ${name})
endforeach()
while(found)
  list(POP_FRONT found name)
  if(NOT EXISTS ${STAGE}/leadscrew/internal/${name})
    stage(${SOURCES}/leadscrew/${name} internal/${name})
  endif()
endwhile()
file(INSTALL DESTINATION ${DESTINATION} TYPE DIRECTORY FILES ${STAGE}/leadscrew)
