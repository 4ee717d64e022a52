# Header-only libraries of the core. Natively they lie on the compiler's own path. A cross compiler must not see the host's
# C library headers beside them, so there each gets a folder of its own, holding one link.

function(leadscrew_header_library NAME FOLDER HEADER)
  add_library(leadscrew_header_${NAME} INTERFACE)
  if(CMAKE_CROSSCOMPILING)
    find_path(LEADSCREW_${NAME}_ROOT ${FOLDER}/${HEADER} PATHS /usr/include NO_DEFAULT_PATH REQUIRED NO_CMAKE_FIND_ROOT_PATH)
    set(view ${CMAKE_BINARY_DIR}/headers/${NAME})
    file(MAKE_DIRECTORY ${view})
    file(CREATE_LINK ${LEADSCREW_${NAME}_ROOT}/${FOLDER} ${view}/${FOLDER} SYMBOLIC)
    target_include_directories(leadscrew_header_${NAME} SYSTEM INTERFACE $<BUILD_INTERFACE:${view}>)
  else()
    find_path(LEADSCREW_${NAME}_ROOT ${FOLDER}/${HEADER} REQUIRED)
  endif()
  install(TARGETS leadscrew_header_${NAME} EXPORT leadscrew)
endfunction()

leadscrew_header_library(expected tl expected.hpp)
leadscrew_header_library(fast_float fast_float fast_float.h)
