cmake_minimum_required(VERSION 3.25)
# A study's published figure does not compile without its source: a paper and a place in it.
file(MAKE_DIRECTORY ${SCRATCH})

function(try STATEMENT STATUS ERRORS)
  file(WRITE ${SCRATCH}/figure.cpp "#include <leadscrew/study/row.hpp>\n"
    "using namespace leadscrew::study;\nvoid figure(Row& row) { ${STATEMENT}; }\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${ROOMS}/study ${SCRATCH}/figure.cpp
    RESULT_VARIABLE status ERROR_VARIABLE errors)
  set(${STATUS} "${status}" PARENT_SCOPE)
  set(${ERRORS} "${errors}" PARENT_SCOPE)
endfunction()

set(sourced "row.published = Published(7, {Paper::fpga_interpolation, \"Table 1\"})")
try("${sourced}" status errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "a figure with its source does not compile:\n${errors}")
endif()
foreach(unsourced "row.published = 7.0" "row.published = Published(7)" "row.published = Published(7, {})"
    "row.published = Published(7, {Paper::fpga_interpolation})" "row.published = Published(7, {Paper::fpga_interpolation, \"\"})"
    "fitted_row(\"\", {}, 7, 7)")
  try("${unsourced}" status errors)
  if(status EQUAL 0)
    message(SEND_ERROR "compiles without a source: ${unsourced}")
  elseif(NOT errors MATCHES "Published|Source|source_without_its_place")
    message(SEND_ERROR "fails for another reason: ${unsourced}\n${errors}")
  endif()
endforeach()
