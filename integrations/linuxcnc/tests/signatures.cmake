cmake_minimum_required(VERSION 3.25)
# The module compiles against the functions of LinuxCNC 2.10 too, as far as they differ from those of the headers that are
# installed: tpAddLine, tpAddCircle and tpAddRigidTap take the greatest jerk behind the acceleration.
#   -D HEADERS=… -D MODULE=… -D COMPILER=… -D SCRATCH=…
file(READ ${HEADERS}/tp.h text)
if(NOT text MATCHES "ini_maxjerk")
  string(REGEX REPLACE "double[ \t\n]+acc," "double acc, double ini_maxjerk," text "${text}")
endif()
string(REGEX MATCHALL "ini_maxjerk" places "${text}")
list(LENGTH places count)
if(NOT count EQUAL 3)
  message(FATAL_ERROR "three functions should take a jerk, not ${count}")
endif()
file(WRITE ${SCRATCH}/tp.h "${text}")
file(GLOB sources ${MODULE}/module/*.c)
foreach(definition LEADSCREW_TP_GIVES_JERK=1 LEADSCREW_TP_GIVES_JERK=0)
  execute_process(COMMAND ${COMPILER} -fsyntax-only -DRTAPI -DSIM -D_GNU_SOURCE -Drealtime -D__MODULE__ -D${definition}
    -I${SCRATCH} -isystem ${HEADERS} -I${MODULE}/planning ${sources} RESULT_VARIABLE status ERROR_VARIABLE output)
  list(APPEND found ${status})
endforeach()
if(NOT found STREQUAL "0;1")
  message(FATAL_ERROR "it should compile with a jerk, and not without; it says\n${output}")
endif()
