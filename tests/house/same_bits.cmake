# Rooms that make motion call no function of the C library that another library rounds otherwise: what a controller, an ARM
# processor and the page make of a program is the same to the last bit (numeric/functions.hpp). Powers are left: of expressions
# in programs, and whole ones of two.
set(functions "log|log2|log10|log1p|expm1|cbrt|atan|atan2|asin|acos|tan|sin|cos|hypot|sinh|cosh|tanh")
set(seen 0)
foreach(room numeric geometry kinematics constraints surfaces gcode toolpath planner interpolator pipeline host)
  file(GLOB sources ${SOURCES}/${room}/*.cpp ${SOURCES}/${room}/*.hpp ${SOURCES}/${room}/*.inl)
  foreach(source ${sources})
    math(EXPR seen "${seen} + 1")
    file(STRINGS ${source} calls REGEX "std::(${functions})[(,;]")
    foreach(call ${calls})
      message(SEND_ERROR "${source}: of the C library: ${call}")
    endforeach()
  endforeach()
endforeach()
if(seen LESS 200)
  message(FATAL_ERROR "only ${seen} sources looked at")
endif()
